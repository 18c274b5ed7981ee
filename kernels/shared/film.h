// Bookkeeping of the film's visibility samples: which surfel of its pixel each sample shows.
#pragma once

#define NO_SURFEL 255         // slot of a sample that shows nothing
#define FILM_COUNT_MASK 0x7f  // of counts[pixel]: surfels of the pixel
#define FILM_HAS_EMPTY 0x80   // of counts[pixel]: set if a sample of the pixel shows nothing

#define THIN_STEP 3  // of a thin film: pixels from one with indirect light of its own to the next, in rows and in columns
