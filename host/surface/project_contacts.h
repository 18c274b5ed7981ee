// Launcher of kernels/project_contacts.cl.
#pragma once

#include "device/features.h"
#include "device/surfels.h"
#include "surface/contacts.h"
#include "surface/surface_pencils.h"

namespace pencil {

/// Adds albedo / pi times the irradiance of the pencils on chosen contacts, times the contacts that each stands for, to
/// outgoing[3][capacity] [W m^-2 sr^-1].
void project_contacts(Kernels& kernels, const Surfels& surfels, const Contacts& contacts, const SurfacePencils& pencils,
                      Buffer<float>& outgoing);

}  // namespace pencil
