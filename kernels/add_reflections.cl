// What surfels of the film show along their lobes, and of their bases otherwise than by even light, joins what they send themselves.

/// launch : 1-D, one work-item per surfel that chains start on
/// in     : radiance[3][chain_capacity] that chains carry; uneven[chain] (follow_surfels.cl); starts[chain_count]: the surfel of each, `shared` chains
///          one after the other have the same; only the first of them is looked at; before[3][capacity]: outgoing without what film pencils say
/// in/out : outgoing[3][capacity] [W m^-2 sr^-1]: the mean of each surfel's chains is added, less what they would say in the even light that film
///          pencils have found: 0 in the mean, so that only noise goes (a control variate)
kernel void add_reflections(global const float *radiance, int chain_capacity, global const float *uneven, global const int *starts,
                            int chain_count, int shared, global const float *before, int capacity, global float *outgoing) {
    int item = get_global_id(0), first = item * shared;
    if (first >= chain_count) return;
    int surfel = starts[first];
    float beside = 0.0f;
    for (int k = 0; k < shared; ++k) beside += uneven[first + k];
    for (int channel = 0; channel < 3; ++channel) {
        float sum = 0.0f;
        for (int k = 0; k < shared; ++k) sum += radiance[(size_t)channel * chain_capacity + first + k];
        size_t at = (size_t)channel * capacity + surfel;
        outgoing[at] += (sum - beside * (outgoing[at] - before[at])) / shared;
    }
}
