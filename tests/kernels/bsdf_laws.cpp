#include "kernels/bsdf_laws.h"

namespace pencil::test {

namespace {

const std::vector<dvec3> viewed_from{{0, 0, 1}, ref::as_float(ref::direction_at(0.6, 1.0)), ref::as_float(ref::direction_at(0.2, 4.0))};

/// Midpoints of cells of equal angles all over the sphere, with their solid angles.
struct SphereGrid {
    static constexpr int heights = 384, azimuths = 192;
    std::vector<dvec3> directions;
    std::vector<double> areas;

    SphereGrid() {
        for (int h = 0; h < heights; ++h)
            for (int a = 0; a < azimuths; ++a) {
                const double low = ref::brdf_pi * h / heights, high = ref::brdf_pi * (h + 1) / heights;
                directions.push_back(
                    ref::as_float(ref::direction_at(std::cos(0.5 * (low + high)), 2.0 * ref::brdf_pi * (a + 0.5) / azimuths)));
                areas.push_back((std::cos(low) - std::cos(high)) * 2.0 * ref::brdf_pi / azimuths);
            }
    }
};

const SphereGrid& grid() {
    static const SphereGrid made;
    return made;
}

std::vector<DeviceBsdf::Value> on_grid(DeviceBsdf& model, const dvec3& omega_o) {
    return model.evaluate(std::vector<dvec3>(grid().directions.size(), omega_o), grid().directions);
}

/// Quantile of the chi-square distribution at significance 1e-4 (Wilson and Hilferty 1931): 3.719 is that of the normal distribution.
double chi_square_limit(int freedom) {
    const double k = 2.0 / (9.0 * freedom);
    return freedom * std::pow(1.0 - k + 3.719 * std::sqrt(k), 3.0);
}

/// Cells for chi-square: sixteen heights of equal angle, eight azimuths.
constexpr int cell_heights = 16, cell_azimuths = 8, cell_count = cell_heights * cell_azimuths;

int cell_of(const dvec3& v) {
    const double turn = std::atan2(v.y, v.x) / (2.0 * ref::brdf_pi);
    const int height = std::min(static_cast<int>(std::acos(std::clamp(v.z, -1.0, 1.0)) / ref::brdf_pi * cell_heights), cell_heights - 1);
    return height * cell_azimuths + std::min(static_cast<int>((turn < 0.0 ? turn + 1.0 : turn) * cell_azimuths), cell_azimuths - 1);
}

std::vector<float4> to_device(const std::vector<dvec3>& vectors) {
    std::vector<float4> out;
    out.reserve(vectors.size());
    for (const dvec3& v : vectors) out.push_back(to_float4(v));
    return out;
}

/// All models, so that programs are built once.
Defines all_models(const std::string& name) {
    Features features;
    features.lobes = true;
    for (int model = 0; model < MATERIAL_BLEND; ++model) features.models.insert(model);
    Defines defines = to_defines(features, 1);
    defines["TEST_MODEL"] = name;
    return defines;
}

}  // namespace

std::vector<dvec3> random_cube(std::uint32_t seed, int count) {
    Random random(seed);
    std::vector<dvec3> out;
    for (int i = 0; i < count; ++i)
        out.emplace_back(random.index(1 << 23) * 0x1p-23, (i + random.uniform()) / count, random.index(1 << 23) * 0x1p-23);
    return out;
}

DeviceBsdf::DeviceBsdf(std::string name, const BsdfRow& row, std::string file)
    : name_(std::move(name)),
      file_(std::move(file)),
      row_(device(), std::vector<Material>{row.row}, "material"),
      tables_(device(), row.tables, "tables"),
      front_(row.front ? 1 : 0) {}

Launch DeviceBsdf::kernel(const std::string& kernel_name) { return programs_.kernel(kernel_name, file_, all_models(name_)); }

std::vector<DeviceBsdf::Value> DeviceBsdf::evaluate(const std::vector<dvec3>& omega_o, const std::vector<dvec3>& omega_i) {
    const int count = static_cast<int>(omega_o.size());
    Buffer<float4> values(device(), 2 * omega_o.size(), "values");
    kernel("bsdf_pairs")
        .args(row_, tables_, front_, Buffer<float4>(device(), to_device(omega_o), "omega_o"),
              Buffer<float4>(device(), to_device(omega_i), "omega_i"), count, values)
        .run(omega_o.size(), "pairs");
    const std::vector<float4> found = values.read();
    std::vector<Value> out;
    for (std::size_t i = 0; i < omega_o.size(); ++i) out.push_back({xyz(found[2 * i]), found[2 * i].w, found[2 * i + 1].x});
    return out;
}

std::vector<DeviceBsdf::Even> DeviceBsdf::even(const std::vector<dvec3>& omega_o) {
    Buffer<float4> values(device(), 2 * omega_o.size(), "even");
    kernel("bsdf_even")
        .args(row_, tables_, front_, Buffer<float4>(device(), to_device(omega_o), "omega_o"), static_cast<int>(omega_o.size()), values)
        .run(omega_o.size(), "even");
    const std::vector<float4> found = values.read();
    std::vector<Even> out;
    for (std::size_t i = 0; i < omega_o.size(); ++i) out.push_back({xyz(found[2 * i]), xyz(found[2 * i + 1])});
    return out;
}

std::vector<DeviceBsdf::Sample> DeviceBsdf::sample(const dvec3& omega_o, const std::vector<dvec3>& u) {
    Buffer<float4> samples(device(), 2 * u.size(), "samples");
    kernel("bsdf_samples")
        .args(row_, tables_, front_, to_float4(omega_o), Buffer<float4>(device(), to_device(u), "u"), static_cast<int>(u.size()), samples)
        .run(u.size(), "samples");
    const std::vector<float4> found = samples.read();
    std::vector<Sample> out;
    for (std::size_t i = 0; i < u.size(); ++i) out.push_back({xyz(found[2 * i]), xyz(found[2 * i + 1]), found[2 * i].w});
    return out;
}

void expect_reference(DeviceBsdf& model, const Scattering& reference, double bound) {
    Random random(1);
    for (const dvec3& o : viewed_from) {
        std::vector<dvec3> in;
        for (int k = 0; k < 200; ++k) in.push_back(ref::as_float(ref::direction_at(random.uniform(-0.98, 0.98), random.uniform(0.0, 6.2))));
        for (const DeviceBsdf::Sample& s : model.sample(o, random_cube(2, 200)))
            if (s.exists() && std::abs(s.omega_i.z) > 0.02) in.push_back(s.omega_i);
        const std::vector<DeviceBsdf::Value> got = model.evaluate(std::vector<dvec3>(in.size(), o), in);
        const dvec3 base = model.even({o})[0].base;
        for (std::size_t k = 0; k < in.size(); ++k) {
            const dvec3 all = got[k].lobes + base * (got[k].base_factor * std::max(in[k].z, 0.0) / ref::brdf_pi),
                        expected = reference(o, in[k]);
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(all[c], expected[c], bound * expected[c] + 1e-6) << "seen from " << o.z << ", of light from height " << in[k].z;
        }
    }
}

void expect_reciprocal(DeviceBsdf& model) {
    Random random(3);
    std::vector<dvec3> o, i;
    for (int k = 0; k < 500; ++k) {
        o.push_back(ref::as_float(ref::direction_at(random.uniform(0.02, 1.0), random.uniform(0.0, 6.2))));
        i.push_back(ref::as_float(ref::direction_at(random.uniform(0.02, 1.0), random.uniform(0.0, 6.2))));
    }
    const std::vector<DeviceBsdf::Value> there = model.evaluate(o, i), back = model.evaluate(i, o);
    for (std::size_t k = 0; k < o.size(); ++k)
        expect_close(there[k].lobes / i[k].z, back[k].lobes / o[k].z, 1e-4, "f of pair " + std::to_string(k) + ", turned round");
}

void expect_base(DeviceBsdf& model, const Scattering& reference, double bound) {
    for (const dvec3& o : viewed_from) {
        const std::vector<DeviceBsdf::Value> values = on_grid(model, o);
        dvec3 beside(0.0);
        double mean = 0.0;
        for (std::size_t k = 0; k < values.size() && grid().directions[k].z > 0.0; ++k) {
            beside += grid().areas[k] * (reference(o, grid().directions[k]) - values[k].lobes);
            mean += grid().areas[k] * grid().directions[k].z / ref::brdf_pi * values[k].base_factor;
        }
        const dvec3 base = model.even({o})[0].base;
        EXPECT_NEAR(base != dvec3(0.0) ? mean : 1.0, 1.0, bound) << "seen from " << o.z;
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(base[c], beside[c], bound * std::max(beside[c], 0.1)) << "seen from " << o.z;
    }
}

void expect_white_furnace(DeviceBsdf& model, double eta) {
    for (const dvec3& o : viewed_from) {
        const std::vector<DeviceBsdf::Value> values = on_grid(model, o);
        const DeviceBsdf::Even even = model.even({o})[0];
        dvec3 sum = even.base;
        for (std::size_t k = 0; k < values.size(); ++k) {
            const double brighter = grid().directions[k].z > 0.0 ? 1.0 : eta * eta;
            sum += grid().areas[k] * brighter * values[k].lobes;
        }
        for (int c = 0; c < 3; ++c) {
            EXPECT_LE(sum[c], 1.0 + 2e-3) << "more than came in, seen from " << o.z;
            EXPECT_GE(even.share[c], 0.0);
            EXPECT_LE(even.share[c], 1.0 + tolerance::few_operations);
        }
    }
}

void expect_samples_follow_pdf(DeviceBsdf& model) {
    const int samples = 1 << 16;
    for (const dvec3& o : viewed_from) {
        std::vector<double> expected(cell_count + 1, 0.0), found(expected);  // the last: no direction
        const std::vector<DeviceBsdf::Value> values = on_grid(model, o);
        double all = 0.0;
        for (std::size_t k = 0; k < values.size(); ++k) {
            expected[static_cast<std::size_t>(cell_of(grid().directions[k]))] += samples * grid().areas[k] * values[k].pdf;
            all += grid().areas[k] * values[k].pdf;
        }
        EXPECT_LE(all, 1.0 + 2e-3) << "seen from " << o.z;
        expected[cell_count] = samples * std::max(1.0 - all, 0.0);
        for (const DeviceBsdf::Sample& s : model.sample(o, random_cube(5, samples))) {
            ASSERT_NEAR(s.exists() ? glm::length(s.omega_i) : 1.0, 1.0, 1e-4);
            found[s.exists() ? static_cast<std::size_t>(cell_of(s.omega_i)) : cell_count] += 1.0;
        }
        double chi_square = 0.0;
        int used = 0;
        for (std::size_t k = 0; k <= cell_count; ++k) {
            if (expected[k] < 20.0) continue;
            // Quadrature of cells that a narrow lobe crosses has an error of its own, up to 1 %.
            const double difference = std::max(std::abs(found[k] - expected[k]) - 0.01 * expected[k], 0.0);
            chi_square += difference * difference / expected[k];
            ++used;
        }
        ASSERT_GT(used, 2);
        EXPECT_LT(chi_square, chi_square_limit(used - 1)) << "seen from " << o.z;
    }
}

void expect_samples_give_lobes(DeviceBsdf& model) {
    const std::vector<dvec3> u = random_cube(6, 1 << 15);
    for (const dvec3& o : viewed_from) {
        dvec3 lobes(0.0), sum(0.0), squares(0.0);
        const std::vector<DeviceBsdf::Value> values = on_grid(model, o);
        for (std::size_t k = 0; k < values.size(); ++k) lobes += grid().areas[k] * values[k].lobes;
        for (const DeviceBsdf::Sample& s : model.sample(o, u)) {
            sum += s.weight;
            squares += s.weight * s.weight;
        }
        const double count = static_cast<double>(u.size());
        const dvec3 mean = sum / count, variance = glm::max(squares / count - mean * mean, 0.0) / count;
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(mean[c], lobes[c], 5.0 * std::sqrt(variance[c]) + 2e-3 * lobes[c]) << "seen from " << o.z << ", channel " << c;
    }
}

}  // namespace pencil::test
