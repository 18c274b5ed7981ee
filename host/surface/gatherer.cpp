#include "surface/gatherer.h"

#include <algorithm>

#include "pencils/low_discrepancy.h"
#include "surface/approach_emitters.h"
#include "surface/contacts.h"
#include "surface/emit_hemispheres.h"
#include "surface/measure_hemispheres.h"
#include "surface/project_contacts.h"
#include "surface/sample_lights.h"
#include "surface/share_hemispheres.h"
#include "surface/sum_guides.h"
#include "surface/sum_hemispheres.h"

namespace pencil {

namespace {

/// Light samples that 16 texels choose from.
constexpr int most_candidates = 24;
/// Contacts are seen from nearer than this share of the radius of a pencil: found by trial.
constexpr float nearness = 0.5F;

/// What draws at random, each by a seed of its own.
enum Draw : std::uint64_t {
    lights_of_texels = 1,
    chains_of_texels,
    lights_of_contacts,
    chains_of_contacts,
    lights_of_guides,
    chains_of_guides
};

/// Who sees guided rays, where pencils have keys of their own.
std::optional<Viewers> guides_of(const SurfacePencils& pencils, int first, Keys keys) {
    return keys == Keys::own ? std::optional<Viewers>({pencils, first, SPOT_RAYS}) : std::nullopt;
}

uint seed_of(std::uint64_t seed, std::uint64_t draw) { return static_cast<uint>(hash64(seed + draw) >> 32); }

}  // namespace

void Gatherer::reserve(Gathered& gathered, int texels) {
    if (gathered.surfels.capacity < texels) {
        const auto& device = kernels_.device();
        gathered.surfels = Surfels(kernels_, texels, "surfels of surface pencils");
        gathered.outgoing = surfel_rgb(device, gathered.surfels.capacity, "radiance to surface pencils");
        gathered.contact = Buffer<unsigned char>(device, static_cast<std::size_t>(gathered.surfels.capacity), "contacts");
    }
    gathered.outgoing.fill_zero();
}

void Gatherer::light(const Surfels& surfels, Buffer<float>& outgoing, std::uint64_t seed, const std::optional<Viewers>& viewers) {
    const int count = lights_.samples.maps.count;
    if (count > 0)
        sample_lights(kernels_, scene_, surfels, lights_.samples, std::max(count / most_candidates, 1), light_draws_,
                      static_cast<uint>(seed), outgoing, viewers);
}

void Gatherer::follow(Surfels& surfels, std::uint64_t seed, const std::optional<Viewers>& viewers) {
    if (kernels_.features().lobes)
        follow_surfels(kernels_, scene_, {lights_.drawn, lights_.drawn}, 0, static_cast<uint>(seed), surfels, viewers);
}

void Gatherer::gather(const GatherSource& source, const GatherTurn& turn, SurfacePencils& pencils, int first, int count) {
    const int chunk = std::max(chunk_ / pencils.texels(), 1);
    for (int at = first; at < first + count; at += chunk) gather_chunk(source, turn, pencils, at, std::min(chunk, first + count - at));
}

void Gatherer::gather_chunk(const GatherSource& source, const GatherTurn& turn, SurfacePencils& pencils, int first, int count) {
    auto& [surfels, outgoing, contact] = seen_;
    const SurfacePencils& world = source.world;
    const Viewers viewers{pencils, first};
    const Reading reading{world.irradiance, source.contacts ? nearness : 0};
    reserve(seen_, count * pencils.texels());
    trace_hemispheres(kernels_, scene_, pencils, first, count, turn.points, surfels);
    measure_hemispheres(kernels_, surfels, 0, first, count, pencils);
    if (turn.reach == Reach::others) approach_emitters(kernels_, scene_, surfels, first, count, lights_.near_film, pencils);
    follow(surfels, seed_of(turn.seed, chains_of_texels), viewers);
    if (source.direct) light(surfels, outgoing, seed_of(turn.seed, lights_of_texels), viewers);
    if (world.count > 0)
        project_surface_pencils(kernels_, scene_, surfels, world, reading.irradiance, source.grid, viewers, reading.nearness, outgoing,
                                contact);
    emit_and_share(source, turn, viewers, count, lights_.near_film, seen_);
    if (source.contacts && world.count > 0) gather_contacts(source, turn, viewers, count);
    sum_hemispheres(kernels_, outgoing, surfels.capacity, 0, first, count, pencils.n, pencils.irradiance);
    if (source.spots) gather_spots(source, turn, pencils, first, count, reading, lights_.near_film);
}

/// Texels and rays towards spots share what is reflected, and what is emitted if spots shine; contacts are left to texels.
void Gatherer::emit_and_share(const GatherSource& source, const GatherTurn& turn, const Viewers& viewers, int count,
                              const Buffer<float>& near_area, Gathered& seen) {
    const bool shared = source.spots && source.spots->shine();
    const auto emit = [&] { emit_hemispheres(kernels_, scene_, seen.surfels, viewers, near_area, seen.outgoing); };
    if (shared) emit();
    if (source.spots)
        share_hemispheres(kernels_, viewers.pencils, viewers.first, count, *source.spots, turn.points, seen.outgoing,
                          seen.surfels.capacity);
    if (!shared) emit();
}

void Gatherer::guide(const DeviceSpots& spots, const GatherTurn& turn, const SurfacePencils& pencils, int first, int count, Keys keys,
                     Guided& guided) {
    reserve(guided.found, count * SPOT_RAYS);
    const auto capacity = static_cast<std::size_t>(guided.found.surfels.capacity);
    if (guided.factors.size() < capacity) guided.factors = Buffer<float>(kernels_.device(), capacity, "factors of guided rays");
    guide_hemispheres(kernels_, scene_, pencils, first, count, spots, turn.points, guided.found.surfels, guided.factors, keys);
    follow(guided.found.surfels, seed_of(turn.seed, chains_of_guides), guides_of(pencils, first, keys));
}

void Gatherer::light_guided(const GatherTurn& turn, const SurfacePencils& pencils, int first, Keys keys, Guided& guided) {
    light(guided.found.surfels, guided.found.outgoing, seed_of(turn.seed, lights_of_guides), guides_of(pencils, first, keys));
}

void Gatherer::emit_guided(const SurfacePencils& pencils, int first, const Buffer<float>& near_area, Guided& guided) {
    emit_hemispheres(kernels_, scene_, guided.found.surfels, {pencils, first, SPOT_RAYS}, near_area, guided.found.outgoing);
}

/// Adds what rays of these pencils towards bright spots find reflected.
void Gatherer::gather_spots(const GatherSource& source, const GatherTurn& turn, SurfacePencils& pencils, int first, int count,
                            const Reading& reading, const Buffer<float>& near_area) {
    guide(*source.spots, turn, pencils, first, count, Keys::own, guided_);
    auto& [surfels, outgoing, contact] = guided_.found;
    light_guided(turn, pencils, first, Keys::own, guided_);
    if (source.spots->shine()) emit_guided(pencils, first, near_area, guided_);
    project_surface_pencils(kernels_, scene_, surfels, source.world, reading.irradiance, source.grid, {pencils, first, SPOT_RAYS},
                            reading.nearness, outgoing, contact);
    sum_guides(kernels_, outgoing, surfels.capacity, guided_.factors, SPOT_RAYS, first, count, pencils.irradiance);
}

/// Light of order 2 and more to contacts among what these pencils see: one order more than the world set has in store for its readers.
void Gatherer::gather_contacts(const GatherSource& source, const GatherTurn& turn, const Viewers& viewers, int count) {
    const std::vector<unsigned char> is_contact = seen_.contact.read(0, static_cast<std::size_t>(seen_.surfels.count));
    const std::vector<SurfacePencil> seeing =
        viewers.pencils.data.read(static_cast<std::size_t>(viewers.first), static_cast<std::size_t>(count));
    const Contacts contacts = choose_contacts(is_contact, seeing, viewers.pencils.texels(), turn.points);
    if (contacts.counts.empty()) return;
    SurfacePencils pencils(kernels_.device(), static_cast<int>(contacts.counts.size()), contact_map);
    place_surface_pencils(kernels_, seen_.surfels, contacts.chosen, pencils);
    reserve(beyond_, pencils.count * pencils.texels());
    auto& [surfels, outgoing, unused] = beyond_;
    const Viewers of_contacts{pencils, 0};
    const Reading reading{source.shorter.allocated() ? source.shorter : source.world.irradiance, 0};
    trace_hemispheres(kernels_, scene_, pencils, 0, pencils.count, turn.points, surfels);
    follow(surfels, seed_of(turn.seed, chains_of_contacts), of_contacts);
    light(surfels, outgoing, seed_of(turn.seed, lights_of_contacts), of_contacts);
    project_surface_pencils(kernels_, scene_, surfels, source.world, reading.irradiance, source.grid, of_contacts, reading.nearness,
                            outgoing, unused);
    emit_and_share(source, turn, of_contacts, pencils.count, lights_.near_texel, beyond_);
    sum_hemispheres(kernels_, outgoing, surfels.capacity, 0, 0, pencils.count, pencils.n, pencils.irradiance);
    if (source.spots) gather_spots(source, turn, pencils, 0, pencils.count, reading, lights_.near_texel);
    project_contacts(kernels_, seen_.surfels, contacts, pencils, seen_.outgoing);
}

}  // namespace pencil
