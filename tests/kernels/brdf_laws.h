// Laws that every model of reflection keeps: reciprocity, white furnace, samples that follow their density, darkness below the horizon.
#pragma once

#include <glm/vec2.hpp>

#include "kernels/kernel_test.h"
#include "reference/brdf_ref.h"
#include "reference/tolerances.h"
#include "shared/material.h"

namespace pencil::test {

/// The functions <name>_evaluate, _albedo, _sample and _pdf of a model on the device.
class DeviceBrdf {
public:
    /// `file`: a program with the model and the kernels of test_brdf.cl.
    DeviceBrdf(std::string name, const Material& row, std::string file = PENCIL_SOURCE_DIR "/tests/kernels/test_brdf.cl");

    struct Value {
        dvec3 f;
        double pdf;
    };
    std::vector<Value> evaluate(const std::vector<dvec3>& omega_o, const std::vector<dvec3>& omega_i);
    std::vector<dvec3> albedo(const std::vector<dvec3>& omega_o);
    std::vector<dvec3> sample(const dvec3& omega_o, const std::vector<glm::vec2>& u);
    Launch kernel(const std::string& kernel_name);
    dvec3 row_albedo() const { return xyz(material_); }

private:
    std::string name_;
    float4 material_;
    std::string file_;
    ProgramCache programs_{device()};
    Buffer<Material> row_;
};

/// Values of `model` are those of the reference.
void expect_reference(DeviceBrdf& model, const ref::Reflection& reference);
/// f(a, b) = f(b, a).
void expect_reciprocal(DeviceBrdf& model);
/// f is 0 where a direction is at or below the horizon; above it, however little, it is finite and not below 0.
void expect_dark_below_horizon(DeviceBrdf& model);
/// The integral of f cos over the hemisphere is the albedo, and at most 1 for a white surface.
void expect_white_furnace(DeviceBrdf& model);
/// Samples fall into cells of the hemisphere as the integral of pdf says (chi-square, significance 1e-4), and the pdf integrates to 1.
void expect_samples_follow_pdf(DeviceBrdf& model);
/// The mean of f cos / pdf over samples is the albedo, within five standard errors.
void expect_samples_give_albedo(DeviceBrdf& model);

}  // namespace pencil::test
