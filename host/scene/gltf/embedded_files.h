// Files inside a glTF text, as data URIs. A parser copies such a text four times on its way to the bytes; taken out before, none is copied.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pencil {

class EmbeddedFiles {
public:
    /// `json` must outlive this. Of its strings, long data URIs in base 64 are those that are taken out.
    explicit EmbeddedFiles(std::string_view json);

    /// The text with a name in place of each of them.
    const std::string& json() const { return json_; }
    /// True if it is one of these names.
    bool has(const std::string& name) const { return index_of(name) < contents_.size(); }
    /// False if what stands there is not in base 64.
    bool decode(const std::string& name, std::vector<unsigned char>& bytes) const;

private:
    std::size_t index_of(const std::string& name) const;

    std::string json_;
    std::vector<std::string_view> contents_;
};

}  // namespace pencil
