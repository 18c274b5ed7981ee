// A short name for bytes: Fowler, Noll and Vo's hash, variant 1a, 64 bits. No protection against intent.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>

namespace pencil {

class Fingerprint {
public:
    void add_bytes(const void* data, std::size_t bytes) {
        const std::uint64_t prime = 0x100000001b3;
        const auto* next = static_cast<const unsigned char*>(data);
        for (const unsigned char* end = next + bytes; next != end; ++next) value_ = (value_ ^ *next) * prime;
    }

    /// 16 hexadecimal digits.
    std::string text() const {
        char digits[17];
        std::snprintf(digits, sizeof(digits), "%016llx", static_cast<unsigned long long>(value_));
        return digits;
    }

private:
    std::uint64_t value_ = 0xcbf29ce484222325;
};

inline std::string fingerprint(const void* data, std::size_t bytes) {
    Fingerprint print;
    print.add_bytes(data, bytes);
    return print.text();
}

}  // namespace pencil
