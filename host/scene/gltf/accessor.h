// Numbers out of the buffers of a glTF file. Every range is checked before it is read: files may lie in each of their indices, offsets,
// strides and counts.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/gltf/gltf_file.h"

namespace pencil {

class AccessorReader {
public:
    explicit AccessorReader(const GltfFile& file) : file_(file) {}

    /// `components` numbers for each element: the first of them if it has more. Integers that stand for fractions are converted. `user` is
    /// blamed: the object that names the accessor.
    std::vector<double> numbers(int accessor, int components, const std::string& user) const;
    /// Of an accessor of unsigned integers.
    std::vector<std::uint32_t> indices(int accessor, const std::string& user) const;
    int components(int accessor, const std::string& user) const;

    /// The content of a buffer view.
    std::string_view bytes(int view, const std::string& user) const;

private:
    /// Elements in a buffer: `count` of them, of `size` bytes, `stride` bytes from one to the next.
    struct Elements {
        const char* first;
        std::size_t count, size, stride;
    };
    Elements elements(int view, std::size_t offset, std::size_t count, std::size_t size, bool may_stride, const std::string& user) const;
    void apply_sparse(const tinygltf::Accessor& accessor, int components, std::vector<double>& values, const std::string& user) const;

    const GltfFile& file_;
};

}  // namespace pencil
