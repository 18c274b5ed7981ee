// Scenes of dust, needles and very different scales, and of places that no light reaches.
#pragma once

#include "scene/scene.h"

namespace pencil {

/// A furnace of albedo 0.5, which shows 2 everywhere, with triangles of `size` anywhere in it that reflect all light: they show 2, too.
Scene dust_scene(std::size_t count, double size);
/// The same with 500 triangles across it, a millionth as wide as long.
Scene needle_scene();
/// A floor of squares one in the other, 1e-6 to 1e6 wide, under a sky of radiance 1: a floor of albedo 0.5 sees nothing else.
Scene decades_scene();
/// A point light of intensity 1 at `d` over a wide floor; the film is a small ceiling 1 above it, all of albedo 0.5.
Scene near_floor_scene(double d);
/// The eye in a closed box of 1 mm with walls of a hundredth of that, on a lit floor of 1 km.
Scene millimetre_box();
/// Four rooms in a row, a gap in each wall between, at the left and at the right in turn; a lamp in the first, the eye in the last.
Scene maze();
/// The eye in a closed two-sided sphere, in a room with a lamp.
Scene eye_in_a_sphere();

}  // namespace pencil
