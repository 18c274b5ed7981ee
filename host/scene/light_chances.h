// With which chances light is drawn from the lights of a scene.
#pragma once

#include <algorithm>

namespace pencil {

/// Mostly in proportion to power, but a share alike: the strongest may be in another room (defensive mixture, Hesterberg 1995). Without lights of
/// power above 0 there are no chances.
class LightChances {
public:
    void add(double power) {
        total_ += std::max(power, 0.0);
        count_ += power > 0 ? 1 : 0;
    }
    bool empty() const { return count_ == 0; }
    /// Of a light of so much power, which was added.
    double of(double power) const { return power > 0 ? power * per_power(power) : 0; }
    /// The same for each unit of that power above 0, to share it out among parts of the light.
    double per_power(double power) const { return (1 - even_share) / total_ + even_share / (count_ * power); }

private:
    static constexpr double even_share = 0.2;

    double total_ = 0;
    int count_ = 0;
};

}  // namespace pencil
