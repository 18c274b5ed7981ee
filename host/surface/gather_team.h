// Devices that share what a set of pencils gathers. Each takes the next few pencils when it is free, so faster ones take more, and what one
// that fails has begun is done by another. The image is that of one device alone, as far as devices round alike.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "film/device_copy.h"
#include "surface/gatherer.h"

namespace pencil {

/// A world set in the host's memory, on its way to other devices.
struct HostWorld {
    int n = 0;
    std::vector<SurfacePencil> pencils;
    std::vector<float4> irradiance, shorter;  // shorter: empty if orders are not limited
    std::vector<Spot> spots;
    bool direct = true, contacts = true;
};

/// A device that helps: it has lights and world set in its own memory.
class GatherHelper {
public:
    /// `copy` must outlive it.
    GatherHelper(DeviceCopy& copy, SurfaceLights lights, int light_draws, int texels);

    void take_world(const HostWorld& world);
    /// Pencils first .. first + count of a set in the host's memory, with maps of n x n texels.
    void gather(const GatherTurn& turn, int n, int first, int count, std::vector<SurfacePencil>& data, std::vector<float4>& irradiance);
    DeviceCopy& copy() { return copy_; }

private:
    DeviceCopy& copy_;
    SurfaceLights lights_;
    Gatherer gatherer_;
    SurfacePencils world_;
    Buffer<float4> shorter_;
    DeviceGrid grid_;
    DeviceSpots spots_;
    bool direct_ = true, contacts_ = true;
};

class GatherTeam {
public:
    GatherTeam(Kernels& kernels, HelperReport& report) : kernels_(kernels), report_(report) {}

    /// A helper that cannot be made is done without.
    void add(DeviceCopy& copy, const std::function<std::unique_ptr<GatherHelper>()>& make);
    bool alone() const { return helpers_.empty(); }
    void take_world(const HostWorld& world);

    /// Gatherer::gather of pencils first .. first + count, by all.
    void gather(Gatherer& own, const GatherSource& source, const GatherTurn& turn, SurfacePencils& pencils, int first, int count);

private:
    void dismiss(const DeviceCopy& copy);
    void dismiss_failed();

    Kernels& kernels_;
    HelperReport& report_;
    std::vector<std::unique_ptr<GatherHelper>> helpers_;
};

}  // namespace pencil
