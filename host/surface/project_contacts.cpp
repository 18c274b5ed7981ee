#include "surface/project_contacts.h"

namespace pencil {

void project_contacts(Kernels& kernels, const Surfels& surfels, const Contacts& contacts, const SurfacePencils& pencils,
                      Buffer<float>& outgoing) {
    if (pencils.count == 0) return;
    const Buffer<int> chosen(kernels.device(), contacts.chosen.surfels, "chosen contacts");
    const Buffer<float> counts(kernels.device(), contacts.counts, "contacts that one stands for");
    kernels.get("project_contacts")
        .args(surfels.store(), chosen, counts, pencils.count, pencils.irradiance, outgoing)
        .run(static_cast<std::size_t>(pencils.count), "project contacts");
}

}  // namespace pencil
