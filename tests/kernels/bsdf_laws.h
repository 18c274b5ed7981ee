// Laws that every model of scattering keeps: white furnace, samples that follow their density, a base that is what is not in the lobes.
#pragma once

#include "kernels/kernel_test.h"
#include "reference/brdf_ref.h"
#include "reference/tolerances.h"
#include "shared/material.h"

namespace pencil::test {

/// A row of materials, the tables that it names, and the side that is looked at.
struct BsdfRow {
    Material row{};
    std::vector<std::uint64_t> tables{0};
    bool front = true;
};

/// The functions <name>_evaluate, ... of a model on the device (bsdf.cl).
class DeviceBsdf {
public:
    /// `file`: a program with the model and the kernels of test_bsdf.cl.
    DeviceBsdf(std::string name, const BsdfRow& row, std::string file = PENCIL_SOURCE_DIR "/tests/kernels/test_bsdf.cl");

    struct Value {
        dvec3 lobes;  // times |cos_i| [1/sr]
        double pdf, base_factor;
    };
    struct Even {
        dvec3 base, share;
    };
    struct Sample {
        dvec3 omega_i, weight;
        double pdf;
        bool exists() const { return weight != dvec3(0.0); }
    };
    std::vector<Value> evaluate(const std::vector<dvec3>& omega_o, const std::vector<dvec3>& omega_i);
    std::vector<Even> even(const std::vector<dvec3>& omega_o);
    std::vector<Sample> sample(const dvec3& omega_o, const std::vector<dvec3>& u);

private:
    Launch kernel(const std::string& kernel_name);

    std::string name_, file_;
    ProgramCache programs_{device()};
    Buffer<Material> row_;
    Buffer<std::uint64_t> tables_;
    int front_;
};

/// f(omega_o, omega_i) |cos_i| [1/sr], lobes and base together.
using Scattering = std::function<dvec3(const dvec3& omega_o, const dvec3& omega_i)>;

/// Lobes and base are together those of the reference, for directions all around and where samples go; relative.
void expect_reference(DeviceBsdf& model, const Scattering& reference, double bound);
/// Of lobes that reflect: f(a, b) = f(b, a).
void expect_reciprocal(DeviceBsdf& model);
/// The mean of base_factor is 1 within `bound`, and base is what the reference has beside the lobes.
void expect_base(DeviceBsdf& model, const Scattering& reference, double bound);
/// What is scattered of light from all around is at most all of it; `eta`: index of the far side, where as much light is eta^2 as bright.
void expect_white_furnace(DeviceBsdf& model, double eta);
/// Samples fall into cells of the sphere as the integral of pdf says (chi-square, significance 1e-4), and pdf integrates to 1 at most.
void expect_samples_follow_pdf(DeviceBsdf& model);
/// The mean of weights of samples is the integral of evaluate, within five standard errors and an error of quadrature.
void expect_samples_give_lobes(DeviceBsdf& model);

/// Stratified points of the unit cube.
std::vector<dvec3> random_cube(std::uint32_t seed, int count);

}  // namespace pencil::test
