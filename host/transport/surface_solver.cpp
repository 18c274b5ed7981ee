#include "transport/surface_solver.h"

#include <algorithm>
#include <cmath>

#include "pencils/low_discrepancy.h"
#include "transport/emit_surfels.h"
#include "transport/light_surfels.h"

namespace pencil {

namespace {

/// Texels that are worked on at once: bounds memory and the length of a launch.
constexpr int chunk_surfels = 1 << 20;
/// Pencils further apart than this in their normals do not stand for each other (REUSE_LEAST_COSINE is the looser bound of use).
constexpr float alike = 0.7F;
/// A pencil is used up to this many spacings away.
constexpr float reach = 1.4F;
constexpr int most_rounds = 8;
/// The world set has at most this many times the pencils asked for: small things in large rooms need more.
constexpr int most_per_wish = 6;
constexpr int most_iterations = 512;
/// Width of the maps of the world set: they are read through the maps of film pencils only.
constexpr int world_map = 8;
/// Texels in a row that share their part of the light samples.
constexpr int light_group = 128;
/// Rounds that fill what no pencil stands for, and their spacing relative to the first.
constexpr int fill_rounds = 2;
constexpr float fill_spacing = 0.25F;
/// The world's bounces stop at this share of the tolerance of the image.
constexpr double tolerance_share = 0.1;

double reflecting_area(const FlatScene& flat) {
    double area = 0;
    for (const Triangle& t : flat.triangles) {
        const glm::dvec3 a(t.v0), b(t.v1), c(t.v2);
        area += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    return area;
}

double power(const std::vector<float4>& irradiance) {
    double sum = 0;
    for (const float4& e : irradiance) sum += static_cast<double>(e.x + e.y + e.z);
    return sum;
}

}  // namespace

SurfaceSolver::SurfaceSolver(Kernels& kernels, const DeviceScene& scene, const FlatScene& flat, const DeviceBvh& bvh,
                             const LightSet& lights, const WorldSet& set, StageClock& clock, std::uint64_t seed)
    : kernels_(kernels),
      scene_(scene),
      flat_(flat),
      bvh_(bvh),
      lights_(lights),
      set_(set),
      clock_(clock),
      seed_(static_cast<uint>(hash64(seed + 17) >> 32)) {
    spacing_ = static_cast<float>(std::sqrt(0.7 * reflecting_area(flat) / set.pencils));
}

/// Surfels not `covered` already that no placed pencil is near to, thinned to `spacing`; they count as placed.
std::vector<int> SurfaceSolver::choose(const Surfels& surfels, const std::vector<bool>& skip, float spacing) {
    const int most = most_per_wish * set_.pencils - world_.count;
    const auto field = [&](int f) {
        return surfels.data.read(static_cast<std::size_t>(f) * static_cast<std::size_t>(surfels.capacity),
                                 static_cast<std::size_t>(surfels.count));
    };
    const std::vector<float> x = field(SURFEL_X), y = field(SURFEL_Y), z = field(SURFEL_Z), nx = field(SURFEL_NX), ny = field(SURFEL_NY),
                             nz = field(SURFEL_NZ);
    std::vector<int> chosen;
    const auto key = [&](float v) { return static_cast<int>(std::floor(v / spacing)); };
    const std::size_t size = x.size(), stride = size % 7919 == 0 ? 1 : 7919;  // a prime: all are visited, neighbours far apart
    for (std::size_t k = 0, i = 0; k < size && static_cast<int>(chosen.size()) < most; ++k, i = (i + stride) % size) {
        const glm::vec3 p(x[i], y[i], z[i]), n(nx[i], ny[i], nz[i]);
        if (n == glm::vec3(0) || (!skip.empty() && skip[i])) continue;
        bool covered = false;
        for (int dz = -1; dz <= 1 && !covered; ++dz)
            for (int dy = -1; dy <= 1 && !covered; ++dy)
                for (int dx = -1; dx <= 1 && !covered; ++dx) {
                    const auto cell = cells_.find({key(p.x) + dx, key(p.y) + dy, key(p.z) + dz});
                    if (cell == cells_.end()) continue;
                    for (std::size_t other : cell->second)
                        covered = covered || (glm::distance(glm::vec3(placed_[other].position), p) < spacing &&
                                              glm::dot(glm::vec3(placed_[other].normal), n) > alike);
                }
        if (covered) continue;
        SurfacePencil pencil{};
        pencil.position = float4(p, 0);
        pencil.normal = float4(n, reach * spacing_);
        cells_[{key(p.x), key(p.y), key(p.z)}].push_back(placed_.size());
        placed_.push_back(pencil);
        chosen.push_back(static_cast<int>(i));
    }
    return chosen;
}

/// Room for the texels of one chunk.
void SurfaceSolver::reserve(int texels) {
    if (surfels_.capacity >= texels) return;
    surfels_ = Surfels(kernels_.device(), texels, "surfels of surface pencils");
    distances_ = Buffer<float>(kernels_.device(), static_cast<std::size_t>(surfels_.capacity), "distances of surface pencils");
    outgoing_ = surfel_rgb(kernels_.device(), surfels_.capacity, "radiance to surface pencils");
}

void SurfaceSolver::gather(SurfacePencils& pencils, int first, int count, Sent sent) {
    const int chunk = std::max(chunk_surfels / pencils.texels(), 1);
    for (int at = first; at < first + count; at += chunk) {
        const int part = std::min(chunk, first + count - at);
        reserve(part * pencils.texels());
        trace_hemispheres(kernels_, scene_, bvh_, pencils, at, part, seed_, surfels_, distances_);
        outgoing_.fill_zero();
        if (sent.emission) emit_surfels(kernels_, scene_, surfels_, true, outgoing_);
        if (sent.direct && lights_.maps.count > 0)
            light_surfels(kernels_, scene_, surfels_, lights_, outgoing_, "direct light to surface pencils", set_.light_stride, light_group,
                          seed_ ^ static_cast<uint>(at));
        if (sent.bounces) project_surface_pencils(kernels_, surfels_, world_, grid_, outgoing_);
        sum_hemispheres(kernels_, outgoing_, distances_, surfels_.capacity, at, part, pencils);
    }
}

void SurfaceSolver::solve(SurfacePencils& seeds, int orders, double tolerance) {
    world_ = SurfacePencils(kernels_.device(), set_.pencils, world_map);
    direct_ = orders < 0 || orders >= 2;
    clock_.run("world pencils", [&] {
        reserve(seeds.count * seeds.texels());
        trace_hemispheres(kernels_, scene_, bvh_, seeds, 0, seeds.count, seed_, surfels_, distances_);
        for (int round = 0; round < most_rounds; ++round) {
            const int before = world_.count;
            place_surface_pencils(kernels_, surfels_, choose(surfels_, {}, spacing_), reach * spacing_, world_);
            if (world_.count == before) break;
            gather(world_, before, world_.count - before, {false, false, false});
        }
        link();
        for (int round = 0; round < fill_rounds && fill(); ++round) link();
    });
    clock_.run("world bounces", [&] { iterate(orders, tolerance); });
}

/// What all texels of the world set see, and the pencils that stand for it.
void SurfaceSolver::link() {
    Kernels& k = kernels_;
    const int texels = world_.count * world_.texels();
    world_surfels_ = Surfels(k.device(), texels, "surfels of the world set");
    Buffer<float> distances(k.device(), static_cast<std::size_t>(world_surfels_.capacity), "distances of the world set");
    links_ = Buffer<glm::ivec4>(k.device(), static_cast<std::size_t>(texels), "links of the world set");
    factors_ = Buffer<float4>(k.device(), static_cast<std::size_t>(texels), "link weights of the world set");
    grid_ = DeviceGrid(k.device(), placed_, flat_);
    trace_hemispheres(kernels_, scene_, bvh_, world_, 0, world_.count, seed_, world_surfels_, distances);
    kernels_.get("link_surfels")
        .args(world_surfels_.data, world_surfels_.capacity, world_surfels_.count, world_.data, grid_.grid, grid_.starts, grid_.entries,
              links_, factors_)
        .run(static_cast<std::size_t>(world_surfels_.count), "link surfels");
}

/// Pencils where texels of the world set see surfaces that none of it stands for: behind edges and in corners. False if there are none.
bool SurfaceSolver::fill() {
    const std::vector<glm::ivec4> links = links_.read();
    std::vector<bool> linked(links.size());
    for (std::size_t i = 0; i < links.size(); ++i) linked[i] = links[i].x >= 0 && links[i].y != LINK_LAST_RESORT;
    const int before = world_.count;
    cells_.clear();
    place_surface_pencils(kernels_, world_surfels_, choose(world_surfels_, linked, fill_spacing * spacing_), reach * spacing_, world_);
    if (world_.count > before) gather(world_, before, world_.count - before, {false, false, false});
    return world_.count > before;
}

/// Irradiance of all pencils of the world set.
std::vector<float4> SurfaceSolver::irradiance(Sent sent) {
    gather(world_, 0, world_.count, sent);
    std::vector<float4> values;
    for (const SurfacePencil& p : world_.data.read(0, static_cast<std::size_t>(world_.count))) values.push_back(p.irradiance);
    return values;
}

/// Step k is irradiance that the film's pencils reflect as order k + 2: it starts with what the maps carry, and reflected light of the
/// light samples joins in step 1.
void SurfaceSolver::iterate(int orders, double tolerance) {
    const auto& device = kernels_.device();
    const std::vector<float4> dark(static_cast<std::size_t>(world_.count), float4(0));
    const bool any = orders < 0 || orders >= 2;
    const std::vector<float4> emitted = any ? irradiance({true, false, false}) : dark;
    const std::vector<float4> lit = any && lights_.maps.count > 0 ? irradiance({false, true, false}) : dark;
    Buffer<float4> source(device, emitted, "irradiance"), target(device, dark, "irradiance"),
        total(device, emitted, "irradiance of all bounces");
    double sum = power(emitted), last = 0;
    for (int k = 1; any && k < most_iterations && (orders < 0 || k + 2 <= orders); ++k) {
        target.fill_zero();
        if (k == 1) target.write(lit);
        kernels_.get("transport_irradiance")
            .args(world_surfels_.data, world_surfels_.capacity, links_, factors_, world_.count, world_.n, source, target, total)
            .run(static_cast<std::size_t>(world_.count), "transport irradiance", 8);
        std::swap(source, target);
        last = power(source.read());
        sum += last;
        if (orders < 0 && last <= tolerance * tolerance_share * sum) break;
    }
    residual_ = sum > 0 && orders < 0 ? last / sum : 0;
    std::vector<SurfacePencil> pencils = world_.data.read(0, static_cast<std::size_t>(world_.count));
    const std::vector<float4> all = total.read();
    for (std::size_t i = 0; i < pencils.size(); ++i) pencils[i].irradiance = all[i];
    world_.data.write(pencils);
}

}  // namespace pencil
