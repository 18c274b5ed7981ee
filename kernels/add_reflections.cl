// What surfels of the film show along their lobes joins what they send themselves.

/// launch : 1-D, one work-item per chain
/// in     : radiance[3][chain_capacity] that chains carry; starts[chain_count]: the surfel of each, `shared` chains one after the other have the
///          same; only the first of them is looked at
/// out    : outgoing[3][capacity] [W m^-2 sr^-1]: the mean of each surfel's chains is added
kernel void add_reflections(global const float *radiance, int chain_capacity, global const int *starts, int chain_count, int shared,
                            int capacity, global float *outgoing) {
    int item = get_global_id(0), first = item * shared;
    if (first >= chain_count) return;
    int surfel = starts[first];
    for (int channel = 0; channel < 3; ++channel) {
        float sum = 0.0f;
        for (int k = 0; k < shared; ++k) sum += radiance[(size_t)channel * chain_capacity + first + k];
        outgoing[(size_t)channel * capacity + surfel] += sum / shared;
    }
}
