// Bytes packed by zlib, unpacked as they are asked for.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace pencil {

class Inflate {
public:
    /// `name`: of the file, for messages. The bytes must stay.
    Inflate(std::string_view packed, const std::string& name);
    ~Inflate();
    Inflate(const Inflate&) = delete;
    Inflate& operator=(const Inflate&) = delete;

    /// Exactly so many bytes; SceneError if there are fewer, or damaged ones.
    void read(void* to, std::size_t bytes);
    /// No more than so many can follow.
    std::size_t most_left() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace pencil
