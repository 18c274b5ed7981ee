#pragma once

namespace pencil {

constexpr double pi = 3.14159265358979323846;
constexpr double golden_ratio = 1.61803398874989484820;

}  // namespace pencil
