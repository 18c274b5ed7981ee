// How many rays of the world set go with the film's. What the world set does not know well is wrong in all pixels at once: the image's mean
// suffers from it, and shows it in no spread among neighbours. How much that is follows from what one world set says pass after pass, where
// pencils stay and only rays differ.
#pragma once

#include "util/archive.h"

namespace pencil {

class WorldBalance {
public:
    /// A pass: the number of its world set, which never falls, the light that the image receives from it, its share of the image, and its rays.
    void add(int set, double light, double share, double rays);

    /// Variance that this gives to the image's mean, relative to its square, times the rays; 0 if no set has had two passes.
    double noise() const;

    /// Rays of the world set for so many of the film: those with which the image and its mean are soonest known. In a pass the relative variance
    /// is `pixel` of a pixel, and `mean` of the mean of all, from whatever cause. 0 if nothing is known.
    double rays(double film_rays, double pixel, double mean) const;

    void transfer(Archive& archive) { archive(set_, passes_, rays_, mean_, squares_, share_, noise_, freedom_, last_rays_); }

private:
    void end_set();

    int set_ = -1;
    // Of this set: passes, their rays, the mean of their light, the sum of the squares of steps from it, and the sum of shares.
    double passes_ = 0, rays_ = 0, mean_ = 0, squares_ = 0, share_ = 0;
    // Of those before: noise times degrees of freedom, and these.
    double noise_ = 0, freedom_ = 0;
    double last_rays_ = 0;
};

}  // namespace pencil
