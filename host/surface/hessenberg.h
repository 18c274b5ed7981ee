// The small side of GMRES (Saad and Schultz 1986) for one channel: in an orthonormal basis v_0 .. v_k that starts with the right side,
// A v_j = sum_i h_ij v_i. Pure arithmetic, no device.
#pragma once

#include <vector>

namespace pencil {

class Hessenberg {
public:
    /// `norm`: of the right side, which is norm * v_0. 0: nothing is to be solved, and the solution is 0.
    explicit Hessenberg(double norm) : residuals_{norm}, ended_(!(norm > 0)) {}

    /// The next column h_0j .. h_(j+1)j of A. The last entry is 0 where the basis cannot grow: then no column may follow.
    void add(const std::vector<double>& column);

    bool ended() const { return ended_; }
    /// Norm of what is left of the right side, the least that any combination of the columns so far leaves.
    double residual() const;
    /// Factors of v_0 .. of the solution with that residual.
    std::vector<double> solution() const;
    /// Norm of the solution.
    double size() const;
    /// Largest eigenvalue in modulus of I - A in the basis, an estimate of the spectral radius of I - A; 0 without columns.
    double spectral_radius() const;

private:
    struct Turn {
        double cosine, sine;
    };

    std::vector<std::vector<double>> columns_;   // as they came
    std::vector<std::vector<double>> triangle_;  // turned to upper triangular form
    std::vector<Turn> turns_;
    std::vector<double> residuals_;  // the right side, turned
    bool ended_;
};

}  // namespace pencil
