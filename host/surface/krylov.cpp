#include "surface/krylov.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "surface/combine_irradiance.h"
#include "surface/dot_irradiance.h"
#include "surface/hessenberg.h"

namespace pencil {

namespace {

/// Vectors of a basis: more are seldom needed, and fewer where they would fill the device.
constexpr int most_vectors = 24, least_vectors = 4;
constexpr std::size_t basis_bytes = std::size_t{64} << 20;
/// What orthogonalising leaves of a vector below this share of it is rounding: the basis is complete.
constexpr double rounding = 1e-6;
/// A restart that leaves more than this share of the residual has met float's rounding.
constexpr double falling = 0.5;
/// Norms below this, of light in its own unit, are none: their inverse, and products with it, would leave float's range.
constexpr double least_norm = 1e-30;

int basis_size(int count) {
    const std::size_t vectors = basis_bytes / (sizeof(float4) * static_cast<std::size_t>(std::max(count, 1)));
    return std::clamp(static_cast<int>(std::min<std::size_t>(vectors, most_vectors)), least_vectors, most_vectors);
}

/// In double precision, since squares of small values would vanish.
glm::dvec3 norm_of(const Buffer<float4>& values) {
    glm::dvec3 sum(0);
    for (const float4& v : values.read()) sum += glm::dvec3(v) * glm::dvec3(v);
    glm::dvec3 norm = glm::sqrt(sum);
    for (int c = 0; c < 3; ++c)
        if (norm[c] < least_norm) norm[c] = 0;
    return norm;
}

glm::dvec3 inverse(const glm::dvec3& v) {
    glm::dvec3 result(0);
    for (int c = 0; c < 3; ++c)
        if (v[c] > 0) result[c] = 1 / v[c];
    return result;
}

/// One cycle of GMRES for A = I - T.
class Cycle {
public:
    Cycle(Kernels& kernels, const Transport& transport, const Buffer<float4>& residual, int count)
        : kernels_(kernels),
          transport_(transport),
          count_(count),
          size_(basis_size(count)),
          basis_(kernels.device(), static_cast<std::size_t>((size_ + 1) * count), "basis of reflections"),
          newest_(kernels.device(), static_cast<std::size_t>(count), "newest vector of the basis"),
          next_(kernels.device(), static_cast<std::size_t>(count), "next vector of the basis") {
        const glm::dvec3 norm = norm_of(residual);
        for (int c = 0; c < 3; ++c) small_[static_cast<std::size_t>(c)] = Hessenberg(norm[c]);
        append(residual, inverse(norm));
    }

    bool full() const { return vectors_ > size_; }
    bool ended() const {
        return std::all_of(
            small_.begin(), small_.end(), [](const Hessenberg& h) { return h.ended(); });
    }
    const Hessenberg& of(int channel) const { return small_[static_cast<std::size_t>(channel)]; }
    glm::dvec3 each(double (Hessenberg::*value)() const) const { return {(of(0).*value)(), (of(1).*value)(), (of(2).*value)()}; }

    /// Takes the next vector of the Krylov space into the basis: one application of T.
    void grow() {
        transport_(newest_, next_);
        combine_irradiance(kernels_, newest_, {glm::dvec3(-1)}, count_, next_);  // T v - v = -A v
        const glm::dvec3 before = norm_of(next_);
        std::vector<glm::dvec3> column = orthogonalise();
        const std::vector<glm::dvec3> rest = orthogonalise();  // once more: the first leaves what cancellation does
        for (std::size_t i = 0; i < column.size(); ++i) column[i] += rest[i];
        glm::dvec3 after = norm_of(next_);
        for (int c = 0; c < 3; ++c)
            if (after[c] <= rounding * before[c] || of(c).ended()) after[c] = 0;
        add_columns(column, after);
        append(next_, -inverse(after));
    }

    /// Adds the combination of the basis with the least residual, but for channels without a sum.
    void add_solution(const glm::dvec3& radius, Buffer<float4>& x) const {
        std::vector<glm::dvec3> factors(static_cast<std::size_t>(vectors_), glm::dvec3(0));
        for (int c = 0; c < 3; ++c) {
            const std::vector<double> y = of(c).solution();
            for (std::size_t k = 0; k < y.size() && radius[c] < most_spectral_radius; ++k) factors[k][c] = y[k];
        }
        combine_irradiance(kernels_, basis_, factors, count_, x);
    }

private:
    void append(const Buffer<float4>& vector, const glm::dvec3& factor) {
        newest_.fill_zero();
        combine_irradiance(kernels_, vector, {factor}, count_, newest_);
        basis_.copy_from(newest_, 0, static_cast<std::size_t>(vectors_++) * static_cast<std::size_t>(count_),
                         static_cast<std::size_t>(count_));
    }

    /// Removes from the next vector what the basis holds of it, and returns that.
    std::vector<glm::dvec3> orthogonalise() {
        std::vector<glm::dvec3> parts = dot_irradiance(kernels_, basis_, vectors_, next_, count_);
        for (glm::dvec3& p : parts) p = -p;
        combine_irradiance(kernels_, basis_, parts, count_, next_);
        return parts;
    }

    void add_columns(const std::vector<glm::dvec3>& column, const glm::dvec3& last) {
        for (int c = 0; c < 3; ++c) {
            Hessenberg& h = small_[static_cast<std::size_t>(c)];
            if (h.ended()) continue;
            std::vector<double> own;
            own.reserve(column.size() + 1);
            for (const glm::dvec3& entry : column) own.push_back(entry[c]);
            own.push_back(last[c]);
            h.add(own);
        }
    }

    Kernels& kernels_;
    const Transport& transport_;
    int count_, size_, vectors_ = 0;
    Buffer<float4> basis_, newest_, next_;
    std::array<Hessenberg, 3> small_{Hessenberg(0), Hessenberg(0), Hessenberg(0)};
};

/// b - x + T x.
void find_residual(Kernels& kernels, const Transport& transport, const Buffer<float4>& b, const Buffer<float4>& x, int count,
                   Buffer<float4>& residual) {
    transport(x, residual);
    combine_irradiance(kernels, b, {glm::dvec3(1)}, count, residual);
    combine_irradiance(kernels, x, {glm::dvec3(-1)}, count, residual);
}

/// Bound of the relative error of solutions of norm `size` with such residuals; infinite where there is none.
glm::dvec3 error_of(const glm::dvec3& residual, const glm::dvec3& radius, const glm::dvec3& size) {
    glm::dvec3 error(0);
    for (int c = 0; c < 3; ++c) {
        if (residual[c] == 0 || radius[c] >= most_spectral_radius) continue;
        error[c] = residual[c] / ((1 - radius[c]) * size[c]);
        if (!std::isfinite(error[c])) error[c] = HUGE_VAL;
    }
    return error;
}

double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

/// Grows the basis until its solution is good enough, it is full, or `most` applications of T are spent. `radius` is the least that the
/// spectral radius may be, and becomes what the basis tells: first estimates may be too large, so that only a whole basis says that there is
/// no sum.
void fill(Cycle& cycle, const glm::dvec3& known_size, double tolerance, int most, KrylovReport& report) {
    const glm::dvec3 least = report.spectral_radius;
    while (!cycle.full() && !cycle.ended() && report.applications < most) {
        cycle.grow();
        ++report.applications;
        report.spectral_radius = glm::max(least, cycle.each(&Hessenberg::spectral_radius));
        const glm::dvec3 size = glm::max(known_size, cycle.each(&Hessenberg::size));
        if (!has_no_sum(report.spectral_radius) &&
            largest(error_of(cycle.each(&Hessenberg::residual), report.spectral_radius, size)) <= 0.5 * tolerance)
            return;
    }
}

}  // namespace

bool has_no_sum(const glm::dvec3& spectral_radius) { return largest(spectral_radius) >= most_spectral_radius; }

KrylovReport solve_reflections(Kernels& kernels, const Transport& transport, const Buffer<float4>& b, int count, double tolerance, int most,
                               Buffer<float4>& total) {
    const auto size = static_cast<std::size_t>(count);
    KrylovReport report;
    Buffer<float4> x(kernels.device(), size, "sum of reflections"), residual(kernels.device(), size, "residual of reflections");
    x.fill_zero();
    residual.copy_from(b, 0, 0, size);
    for (double error = HUGE_VAL; error > tolerance && report.applications < most;) {
        Cycle cycle(kernels, transport, residual, count);
        fill(cycle, norm_of(x), tolerance, most, report);
        cycle.add_solution(report.spectral_radius, x);
        find_residual(kernels, transport, b, x, count, residual);
        ++report.applications;
        report.error = error_of(norm_of(residual), report.spectral_radius, norm_of(x));
        const double last = std::exchange(error, largest(report.error));
        if (error >= falling * last) break;
    }
    combine_irradiance(kernels, x, {glm::dvec3(1)}, count, total);
    return report;
}

}  // namespace pencil
