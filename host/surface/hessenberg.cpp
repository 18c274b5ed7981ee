#include "surface/hessenberg.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pencil {

namespace {

/// Powers up to 2 to this number: eigenvalues nearer to each other than a millionth are one for all purposes here.
constexpr int squarings = 24;

struct Square {
    std::size_t n;
    std::vector<double> values;  // row by row
    double& at(std::size_t i, std::size_t j) { return values[i * n + j]; }
    double at(std::size_t i, std::size_t j) const { return values[i * n + j]; }
};

Square squared(const Square& m) {
    Square out{m.n, std::vector<double>(m.n * m.n, 0.0)};
    for (std::size_t i = 0; i < m.n; ++i)
        for (std::size_t k = 0; k < m.n; ++k)
            for (std::size_t j = 0; j < m.n; ++j) out.at(i, j) += m.at(i, k) * m.at(k, j);
    return out;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); }

}  // namespace

void Hessenberg::add(const std::vector<double>& column) {
    const std::size_t j = columns_.size();
    columns_.push_back(column);
    std::vector<double> turned = column;
    for (std::size_t i = 0; i < j; ++i) {
        const double a = turned[i], b = turned[i + 1];
        turned[i] = turns_[i].cosine * a + turns_[i].sine * b;
        turned[i + 1] = turns_[i].cosine * b - turns_[i].sine * a;
    }
    const double length = std::hypot(turned[j], turned[j + 1]);
    const Turn turn = length > 0 ? Turn{turned[j] / length, turned[j + 1] / length} : Turn{1, 0};
    turned[j] = length;
    turned.pop_back();
    turns_.push_back(turn);
    triangle_.push_back(turned);
    residuals_.push_back(-turn.sine * residuals_[j]);
    residuals_[j] *= turn.cosine;
    ended_ = !(column.back() > 0);
}

double Hessenberg::residual() const { return std::abs(residuals_.back()); }

std::vector<double> Hessenberg::solution() const {
    std::vector<double> y(columns_.size(), 0.0);
    for (std::size_t j = y.size(); j-- > 0;) {
        double sum = residuals_[j];
        for (std::size_t k = j + 1; k < y.size(); ++k) sum -= triangle_[k][j] * y[k];
        y[j] = triangle_[j][j] > 0 ? sum / triangle_[j][j] : 0.0;  // 0: A is singular here, and leaves this part alone
    }
    return y;
}

double Hessenberg::size() const {
    const std::vector<double> y = solution();
    return std::sqrt(dot(y, y));
}

/// Gelfand's formula: the limit of norm(B^m)^(1/m), with m doubled by squaring. The norms go into a sum of logarithms, so that nothing grows
/// or vanishes.
double Hessenberg::spectral_radius() const {
    const std::size_t n = columns_.size();
    Square power{n, std::vector<double>(n * n, 0.0)};  // I - A
    for (std::size_t j = 0; j < n; ++j) {
        power.at(j, j) = 1;
        for (std::size_t i = 0; i < std::min(j + 2, n); ++i) power.at(i, j) -= columns_[j][i];
    }
    double logarithm = 0;
    for (int k = 0; k < squarings; ++k) {
        const double norm = std::sqrt(dot(power.values, power.values));
        if (!(norm > 0)) return 0;
        for (double& x : power.values) x /= norm;
        logarithm += std::ldexp(std::log(norm), -k);
        power = squared(power);
    }
    return std::exp(logarithm);
}

}  // namespace pencil
