// The arithmetic of kernels/lib/packet.cl, through a test-only kernel. What else packets do is in the self-test (test_layout.cpp).
#include <cmath>

#include "cl/kernel_source.h"
#include "kernels/kernel_test.h"

namespace {

using namespace pencil;
using namespace pencil::test;

const char* const packet_kernels = R"CL(
#include "lib/packet.cl"
kernel void roots(global const float *in, int packets, global float *out) {
    int i = get_global_id(0) * PENCIL_WIDTH;
    if (get_global_id(0) < packets) PACKET_STORE(packet_rsqrt(PACKET_LOAD(in + i)), out + i);
}
)CL";

class Packet : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Widths, Packet, testing::Values(1, 4, 8, 16));

TEST_P(Packet, ReciprocalRootIsGoodToFourUnitsInTheLastPlace) {
    const int width = GetParam(), mantissas = 1 << 14;
    std::vector<float> values;
    Random random(5);
    for (int exponent = -126; exponent < 128; exponent += 6)
        for (int i = 0; i < mantissas; ++i) values.push_back(static_cast<float>(std::ldexp(1.0 + random.uniform(), exponent)));
    const Buffer<float> in(device(), values, "values");
    Buffer<float> out(device(), values.size(), "roots");
    cl::Program program(device()->context(), resolve_includes(packet_kernels, "test_packet"));
    const std::string options = "-cl-std=CL1.2 -DPENCIL_WIDTH=" + std::to_string(width);
    program.build({device()->cl_device()}, options.c_str());
    const int packets = static_cast<int>(values.size()) / width;
    Launch(device(), cl::Kernel(program, "roots"), "roots").args(in, packets, out).run(static_cast<std::size_t>(packets), "roots");
    const std::vector<float> roots = out.read();
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double expected = 1.0 / std::sqrt(static_cast<double>(values[i]));
        const double last_place = std::ldexp(1.0, std::ilogb(expected) - 23);
        ASSERT_LE(std::abs(roots[i] - expected), 4.0 * last_place) << values[i];
    }
}

}  // namespace
