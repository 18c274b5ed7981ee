// Weighted mean of numbers that come in groups, one group after the other, and how well it is known.
#pragma once

#include <vector>

#include "util/archive.h"

namespace pencil {

class WeightedMean {
public:
    /// `group`: its number.
    void add(double value, double weight, int group);

    int count() const { return count_; }
    double mean() const { return first_ + all_.mean(); }

    /// Square of the standard error of the mean, as the spread of the values tells it; infinite before two.
    double square_error() const;
    /// The same as the spread of the groups' means tells it, which holds what the values of a group share; 0 before there are groups enough.
    double square_error_of_groups() const;

    void transfer(Archive& archive) { archive(count_, first_, all_, groups_, square_weight_, square_step_, square_square_); }

private:
    struct Sum {
        int group = 0;
        double weight = 0, value = 0;  // sums of weight, and of weight * (value - first)
        double mean() const { return weight > 0 ? value / weight : 0; }
        void add(double step, double more) {
            weight += more;
            value += more * step;
        }
    };

    int count_ = 0;
    double first_ = 0;
    Sum all_;
    std::vector<Sum> groups_;
    double square_weight_ = 0, square_step_ = 0, square_square_ = 0;  // sums of weight^2 * (value - first)^k
};

}  // namespace pencil
