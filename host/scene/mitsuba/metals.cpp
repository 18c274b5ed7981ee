// Components of linear sRGB of the spectra in Palik, Handbook of Optical Constants of Solids (1985 to 1998), and of the SOPRA database, as
// integrated by Mitsuba 3.9 in its mode of three components; those below zero are zero.
#include "scene/mitsuba/metals.h"

#include <map>

namespace pencil {
namespace {

const std::map<std::string, ComplexIndex> metals = {
    {"a-C", {{2.94405F, 2.22714F, 1.96816F}, {0.887465F, 0.799299F, 0.81529F}}},
    {"Ag", {{0.155276F, 0.116728F, 0.138388F}, {4.82835F, 3.12222F, 2.1469F}}},
    {"Al", {{1.6575F, 0.880405F, 0.521244F}, {9.22381F, 6.2695F, 4.837F}}},
    {"AlAs", {{3.6053F, 3.23294F, 2.21632F}, {0.000679437F, 0.0F, 0.00751271F}}},
    {"AlSb", {{0.0F, 4.13937F, 4.66925F}, {0.0F, 0.0940091F, 1.30057F}}},
    {"Au", {{0.143036F, 0.375307F, 1.44205F}, {3.983F, 2.38556F, 1.60336F}}},
    {"Be", {{4.18501F, 3.18503F, 2.78406F}, {3.83547F, 3.01012F, 2.86899F}}},
    {"Cr", {{4.36967F, 2.91651F, 1.6549F}, {5.20655F, 4.23131F, 3.7547F}}},
    {"CsI", {{2.1449F, 1.70232F, 1.66243F}, {0.0F, 0.0F, 0.0F}}},
    {"Cu", {{0.201005F, 0.92375F, 1.10222F}, {3.91326F, 2.45305F, 2.14209F}}},
    {"Cu2O", {{3.55177F, 2.94987F, 2.75188F}, {0.114207F, 0.193897F, 0.606134F}}},
    {"CuO", {{3.24754F, 2.44781F, 2.21022F}, {0.52109F, 0.570031F, 0.722179F}}},
    {"d-C", {{2.70872F, 2.31883F, 2.2289F}, {0.0F, 0.0F, 0.0F}}},
    {"Hg", {{2.39894F, 1.44003F, 0.90957F}, {6.32759F, 4.37192F, 3.42176F}}},
    {"HgTe", {{4.77904F, 3.2312F, 2.6599F}, {1.63161F, 1.58081F, 1.72929F}}},
    {"Ir", {{3.0863F, 2.08219F, 1.61791F}, {5.59215F, 4.06709F, 3.26731F}}},
    {"K", {{0.0640432F, 0.0464098F, 0.0381849F}, {2.1042F, 1.34894F, 0.913126F}}},
    {"Li", {{0.265791F, 0.195618F, 0.220949F}, {3.54015F, 2.31112F, 1.66861F}}},
    {"MgO", {{2.08958F, 1.65072F, 1.59488F}, {0.0F, 0.0F, 0.0F}}},
    {"Mo", {{4.48397F, 3.52513F, 2.77631F}, {4.11144F, 3.42083F, 3.15061F}}},
    {"Nb", {{3.42007F, 2.79009F, 2.39563F}, {3.44139F, 2.73767F, 2.57975F}}},
    {"Rh", {{2.58579F, 1.86022F, 1.55426F}, {6.78226F, 4.70299F, 3.97607F}}},
    {"Se", {{4.05831F, 2.84294F, 2.82085F}, {0.75405F, 0.638444F, 0.521808F}}},
    {"SiC", {{3.17234F, 2.52597F, 2.47937F}, {0.0F, 0.0F, 1.01925e-05F}}},
    {"SnTe", {{4.52425F, 1.98164F, 1.28159F}, {0.0F, 0.0F, 0.0F}}},
    {"Ta", {{2.06272F, 2.39294F, 2.62793F}, {2.40836F, 1.74149F, 1.94703F}}},
    {"Te", {{7.39023F, 4.4821F, 2.63711F}, {3.25602F, 3.52706F, 3.29205F}}},
    {"ThF4", {{1.83071F, 1.44223F, 1.38765F}, {0.0F, 0.0F, 0.0F}}},
    {"TiC", {{3.70053F, 2.83742F, 2.58229F}, {3.26564F, 2.35159F, 2.17279F}}},
    {"TiN", {{1.64845F, 1.15052F, 1.37982F}, {3.36833F, 1.9435F, 1.10207F}}},
    {"TiO2", {{3.45661F, 2.80174F, 2.90517F}, {0.000105265F, 0.0F, 0.000652887F}}},
    {"VC", {{3.65757F, 2.75274F, 2.53267F}, {3.0683F, 2.19869F, 1.96319F}}},
    {"VN", {{2.8656F, 2.11919F, 1.94009F}, {3.03224F, 2.05612F, 1.61631F}}},
    {"W", {{4.37082F, 3.30025F, 2.99841F}, {3.50064F, 2.60487F, 2.27323F}}},
};

}  // namespace

std::optional<ComplexIndex> metal(const std::string& name) {
    const std::string suffix = "_palik";  // the same data
    const bool has_suffix = name.size() > suffix.size() && name.compare(name.size() - suffix.size(), suffix.size(), suffix) == 0;
    const auto place = metals.find(has_suffix ? name.substr(0, name.size() - suffix.size()) : name);
    return place == metals.end() ? std::nullopt : std::optional<ComplexIndex>(place->second);
}

std::vector<std::string> metal_names() {
    std::vector<std::string> names;
    names.reserve(metals.size());
    for (const auto& row : metals) names.push_back(row.first);
    return names;
}

}  // namespace pencil
