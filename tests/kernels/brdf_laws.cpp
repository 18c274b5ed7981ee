#include "kernels/brdf_laws.h"

namespace pencil::test {

namespace {

/// Directions of all heights, from the normal to near the horizon, and of all azimuths.
std::vector<dvec3> upper_directions(std::uint32_t seed, int count) {
    Random random(seed);
    std::vector<dvec3> out{{0, 0, 1}, ref::as_float(ref::direction_at(0.05, 2.0))};
    while (static_cast<int>(out.size()) < count)
        out.push_back(ref::as_float(ref::direction_at(random.uniform(0.02, 1.0), random.uniform(0.0, 6.2))));
    return out;
}

const std::vector<dvec3> viewed_from{{0, 0, 1}, ref::as_float(ref::direction_at(0.6, 1.0)), ref::as_float(ref::direction_at(0.05, 4.0))};

std::vector<glm::vec2> random_square(std::uint32_t seed, int count) {
    Random random(seed);
    std::vector<glm::vec2> out;
    for (int i = 0; i < count; ++i) {
        const float x = static_cast<float>(random.index(1 << 24)), y = static_cast<float>(random.index(1 << 24));
        out.emplace_back(x * 0x1p-24F, y * 0x1p-24F);  // below 1
    }
    return out;
}

/// Quantile of the chi-square distribution at significance 1e-4 (Wilson and Hilferty 1931): 3.719 is that of the normal distribution.
double chi_square_limit(int freedom) {
    const double k = 2.0 / (9.0 * freedom);
    return freedom * std::pow(1.0 - k + 3.719 * std::sqrt(k), 3.0);
}

}  // namespace

DeviceBrdf::DeviceBrdf(std::string name, const Material& row, std::string file)
    : name_(std::move(name)), material_(row.albedo), file_(std::move(file)), row_(device(), std::vector<Material>{row}, "material") {}

Launch DeviceBrdf::kernel(const std::string& kernel_name) { return programs_.kernel(kernel_name, file_, {{"TEST_MODEL", name_}}); }

std::vector<DeviceBrdf::Value> DeviceBrdf::evaluate(const std::vector<dvec3>& omega_o, const std::vector<dvec3>& omega_i) {
    std::vector<float4> o, i;
    for (const dvec3& v : omega_o) o.push_back(to_float4(v));
    for (const dvec3& v : omega_i) i.push_back(to_float4(v));
    Buffer<float4> values(device(), o.size(), "values");
    kernel("brdf_pairs")
        .args(row_, Buffer<float4>(device(), o, "omega_o"), Buffer<float4>(device(), i, "omega_i"), static_cast<int>(o.size()), values)
        .run(o.size(), "pairs");
    std::vector<Value> out;
    for (const float4& v : values.read()) out.push_back({xyz(v), static_cast<double>(v.w)});
    return out;
}

std::vector<dvec3> DeviceBrdf::albedo(const std::vector<dvec3>& omega_o) {
    std::vector<float4> o;
    for (const dvec3& v : omega_o) o.push_back(to_float4(v));
    Buffer<float4> albedos(device(), o.size(), "albedos");
    kernel("brdf_albedos").args(row_, Buffer<float4>(device(), o, "omega_o"), static_cast<int>(o.size()), albedos).run(o.size(), "albedos");
    std::vector<dvec3> out;
    for (const float4& v : albedos.read()) out.push_back(xyz(v));
    return out;
}

std::vector<dvec3> DeviceBrdf::sample(const dvec3& omega_o, const std::vector<glm::vec2>& u) {
    Buffer<float4> omega_i(device(), u.size(), "samples");
    kernel("brdf_samples")
        .args(row_, to_float4(omega_o), Buffer<glm::vec2>(device(), u, "u"), static_cast<int>(u.size()), omega_i)
        .run(u.size(), "samples");
    std::vector<dvec3> out;
    for (const float4& v : omega_i.read()) out.push_back(xyz(v));
    return out;
}

void expect_reference(DeviceBrdf& model, const ref::Reflection& reference) {
    const std::vector<dvec3> o = upper_directions(1, 200), i = upper_directions(2, 200);
    const std::vector<DeviceBrdf::Value> got = model.evaluate(o, i);
    for (std::size_t k = 0; k < o.size(); ++k)
        expect_close(got[k].f, reference(model.row_albedo(), o[k], i[k]), tolerance::few_operations, "f of pair " + std::to_string(k));
}

void expect_reciprocal(DeviceBrdf& model) {
    const std::vector<dvec3> o = upper_directions(3, 500), i = upper_directions(4, 500);
    const std::vector<DeviceBrdf::Value> there = model.evaluate(o, i), back = model.evaluate(i, o);
    for (std::size_t k = 0; k < o.size(); ++k)
        expect_close(there[k].f, back[k].f, tolerance::few_operations, "f of pair " + std::to_string(k) + ", turned round");
}

void expect_dark_below_horizon(DeviceBrdf& model) {
    std::vector<dvec3> o, i;
    for (const double z : {0.0, -1e-6, -0.3, -1.0})
        for (const dvec3& up : viewed_from) {
            o.insert(o.end(), {up, ref::direction_at(z, 0.3), ref::direction_at(z, 5.0)});
            i.insert(i.end(), {ref::direction_at(z, 0.3), up, ref::direction_at(z, 2.0)});
        }
    for (const DeviceBrdf::Value& v : model.evaluate(o, i)) EXPECT_EQ(v.f, dvec3(0.0));
    const std::vector<dvec3> below(3, ref::direction_at(-0.2, 1.0)), grazing(3, ref::direction_at(1e-6, 1.0));
    for (const DeviceBrdf::Value& v : model.evaluate(viewed_from, below)) EXPECT_EQ(v.pdf, 0.0);
    for (const auto& values :
         {model.evaluate(viewed_from, grazing), model.evaluate(grazing, viewed_from), model.evaluate(grazing, grazing)})
        for (const DeviceBrdf::Value& v : values)
            for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::isfinite(v.f[c]) && v.f[c] >= 0.0) << v.f[c];
    for (const dvec3& a : model.albedo({ref::direction_at(0.0, 0.0), ref::direction_at(1e-6, 0.0)}))
        for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::isfinite(a[c]) && a[c] >= 0.0) << a[c];
}

void expect_white_furnace(DeviceBrdf& model) {
    // Midpoints of cells of equal cosine-weighted solid angle: z^2 is uniform. The rule's own error, for f as steep as 1 / (z + 0.05), is
    // 2e-4.
    const int rings = 2048, sectors = 16;
    std::vector<dvec3> grid;
    for (int ring = 0; ring < rings; ++ring)
        for (int sector = 0; sector < sectors; ++sector)
            grid.push_back(ref::direction_at(std::sqrt((ring + 0.5) / rings), (sector + 0.5) * 2.0 * ref::brdf_pi / sectors));
    const std::vector<dvec3> albedos = model.albedo(viewed_from);
    for (std::size_t k = 0; k < viewed_from.size(); ++k) {
        dvec3 sum(0.0);
        for (const DeviceBrdf::Value& v : model.evaluate(std::vector<dvec3>(grid.size(), viewed_from[k]), grid)) sum += v.f;
        sum *= ref::brdf_pi / (rings * sectors);
        expect_close(albedos[k], sum, 4e-4, "albedo towards " + std::to_string(viewed_from[k].z));
        for (int c = 0; c < 3; ++c)
            EXPECT_LE(albedos[k][c], model.row_albedo()[c] * (1.0 + tolerance::few_operations)) << "more than came in";
    }
}

void expect_samples_follow_pdf(DeviceBrdf& model) {
    const int heights = 8, sectors = 8, fine = 32, samples = 1 << 16;
    const double area = 2.0 * ref::brdf_pi / (heights * sectors * fine * fine);  // solid angle is dz dphi
    std::vector<dvec3> grid;
    for (int z = 0; z < heights * fine; ++z)
        for (int s = 0; s < sectors * fine; ++s)
            grid.push_back(ref::direction_at((z + 0.5) / (heights * fine), (s + 0.5) * 2.0 * ref::brdf_pi / (sectors * fine)));
    for (const dvec3& o : viewed_from) {
        std::vector<double> expected(static_cast<std::size_t>(heights * sectors), 0.0), found(expected);
        const std::vector<DeviceBrdf::Value> values = model.evaluate(std::vector<dvec3>(grid.size(), o), grid);
        double all = 0.0;
        for (std::size_t k = 0; k < grid.size(); ++k) {
            const std::size_t height = k / static_cast<std::size_t>(fine * fine * sectors),
                              sector = k % static_cast<std::size_t>(sectors * fine) / fine;
            expected[height * sectors + sector] += samples * area * values[k].pdf;
            all += area * values[k].pdf;
        }
        EXPECT_NEAR(all, 1.0, 1e-3);
        for (const dvec3& v : model.sample(o, random_square(5, samples))) {
            ASSERT_NEAR(glm::length(v), 1.0, tolerance::few_operations);
            ASSERT_GE(v.z, 0.0);
            const double turn = std::atan2(v.y, v.x) / (2.0 * ref::brdf_pi);
            const int height = std::min(static_cast<int>(v.z * heights), heights - 1);
            const int sector = std::min(static_cast<int>((turn < 0.0 ? turn + 1.0 : turn) * sectors), sectors - 1);
            found[static_cast<std::size_t>(height * sectors + sector)] += 1.0;
        }
        double chi_square = 0.0;
        for (std::size_t k = 0; k < found.size(); ++k) {
            ASSERT_GT(expected[k], 5.0) << "too few samples for the test in cell " << k;
            chi_square += (found[k] - expected[k]) * (found[k] - expected[k]) / expected[k];
        }
        EXPECT_LT(chi_square, chi_square_limit(heights * sectors - 1)) << "towards " << o.z;
    }
}

void expect_samples_give_albedo(DeviceBrdf& model) {
    const std::vector<glm::vec2> u = random_square(6, 1 << 15);
    const std::vector<dvec3> albedos = model.albedo(viewed_from);
    for (std::size_t k = 0; k < viewed_from.size(); ++k) {
        const std::vector<dvec3> omega_i = model.sample(viewed_from[k], u);
        const std::vector<DeviceBrdf::Value> values = model.evaluate(std::vector<dvec3>(u.size(), viewed_from[k]), omega_i);
        dvec3 sum(0.0), squares(0.0);
        for (std::size_t s = 0; s < u.size(); ++s) {
            if (omega_i[s].z <= 0.0) continue;
            const dvec3 estimate = values[s].f * omega_i[s].z / values[s].pdf;
            sum += estimate;
            squares += estimate * estimate;
        }
        const double count = static_cast<double>(u.size());
        const dvec3 mean = sum / count, variance = glm::max(squares / count - mean * mean, 0.0) / count;
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(mean[c], albedos[k][c], 5.0 * std::sqrt(variance[c]) + tolerance::few_operations * albedos[k][c])
                << "towards " << viewed_from[k].z << ", channel " << c;
    }
}

}  // namespace pencil::test
