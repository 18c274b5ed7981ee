// `pencil compare` from outside: images made by the renderer and by oiiotool, results read back as JSON.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/fixtures.h"
#include "cli/run_program.h"

namespace pencil_test {
namespace {

using Json = nlohmann::json;

class Compare : public testing::Test {
protected:
    /// Images of one colour by oiiotool, all in one run: most of its time is its start.
    struct Constant {
        std::string name, colour, size = "8x6";
    };
    std::vector<std::string> constants(const std::vector<Constant>& images) const {
        std::vector<std::string> command{"oiiotool"}, files;
        for (const Constant& image : images) {
            files.push_back((folder / image.name).string());
            command.insert(command.end(), {"--pattern", "constant:color=" + image.colour, image.size, "3", "-o", files.back()});
        }
        const RunResult made = run(command);
        EXPECT_EQ(made.code, 0) << made.err;
        return files;
    }
    std::string constant(const std::string& name, const std::string& colour) const { return constants({{name, colour}}).front(); }
    /// 1.1 and 1.
    std::vector<std::string> two() const { return constants({{"a.exr", "1.1,1.1,1.1"}, {"b.exr", "1,1,1"}}); }
    Json compare(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "compare");
        arguments.emplace_back("--json");
        result = run_pencil(arguments);
        EXPECT_EQ(result.code, 0) << result.err;
        return result.code == 0 ? Json::parse(result.out) : Json();
    }
    void expect_refused(const std::vector<std::string>& arguments, int code, const std::string& reason) {
        std::vector<std::string> all{"compare"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        result = run_pencil(all);
        EXPECT_EQ(result.code, code) << result.err;
        EXPECT_NE(result.err.find(reason), std::string::npos) << result.err;
    }

    Folder folder;
    RunResult result;
};

TEST_F(Compare, ConstantImages) {
    const std::vector<std::string> images = two();
    const std::string &a = images[0], &b = images[1];
    const Json beauty = compare({a, b})["layers"][0];
    EXPECT_EQ(beauty["name"], "beauty");
    EXPECT_NEAR(beauty["rmse"].get<double>(), 0.1, 1e-6);
    EXPECT_NEAR(beauty["rel_mse"].get<double>(), 0.01 / 1.01, 1e-7);
    EXPECT_NEAR(beauty["mean_ratio"].get<double>(), 1.1, 1e-6);
    EXPECT_NEAR(beauty["psnr_db"].get<double>(), 20, 1e-4);
    // Exposure 0.18: greys of 0.198 and 0.18, L* = 116 cbrt(Y) - 16.
    EXPECT_NEAR(beauty["lab_rms"].get<double>(), 116 * (std::cbrt(0.198) - std::cbrt(0.18)), 1e-4);
    EXPECT_TRUE(compare({a, a})["layers"][0]["psnr_db"].is_null()) << "infinite";
}

TEST_F(Compare, TableNamesEveryMetric) {
    const std::vector<std::string> images = two();
    const std::string &a = images[0], &b = images[1];
    result = run_pencil({"compare", a, b});
    EXPECT_EQ(result.code, 0) << result.err;
    for (const char* word : {"RMSE", "relMSE", "mean ratio", "PSNR", "L*a*b*", "beauty", "8x6", "1.1000", "20.00"})
        EXPECT_NE(result.out.find(word), std::string::npos) << word << "\n" << result.out;
}

TEST_F(Compare, LayersOfRenders) {
    const std::string scene = folder.write("room.xml", small_scene());
    std::vector<std::string> files;
    for (const char* pencils : {"16", "24"}) {
        files.push_back((folder / (std::string(pencils) + ".exr")).string());
        std::vector<std::string> arguments{"render", scene, "--quiet", "-o", files.back()};
        arguments.insert(arguments.end(), quick().begin(), quick().end());
        arguments[arguments.size() - 7] = pencils;  // quick() begins with --pencils 16
        arguments.insert(arguments.end(), {"--bounces", pencils == std::string("16") ? "2" : "3"});
        ASSERT_EQ(run_pencil(arguments).code, 0);
    }
    const Json json = compare({files[0], files[1]});
    EXPECT_TRUE(json["warnings"].empty()) << json["warnings"];
    EXPECT_EQ(json["only_in_reference"], Json::array({"bounce3"}));
    std::map<std::string, Json> layers;
    for (const Json& layer : json["layers"]) layers[layer["name"]] = layer;
    EXPECT_EQ(layers.at("direct")["rmse"], 0) << "direct light does not go through pencils";
    EXPECT_GT(layers.at("bounce2")["rmse"], 0);
    EXPECT_GT(layers.at("beauty")["lab_rms"], 0);
    EXPECT_TRUE(layers.at("depth")["lab_rms"].is_null());

    const std::string other = (folder / "other.exr").string();
    const std::string dark = folder.write("dark.xml", small_scene(false));
    ASSERT_EQ(run_pencil({"render", dark, "--quiet", "--aov", "none", "-o", other}).code, 0);
    const Json warned = compare({other, files[0]});
    ASSERT_EQ(warned["warnings"].size(), 1U) << warned["warnings"];
    EXPECT_NE(warned["warnings"][0].get<std::string>().find("different scenes: dark.xml and room.xml"), std::string::npos);
    EXPECT_NE(result.err.find("different scenes"), std::string::npos);
}

TEST_F(Compare, BlackLayersAndUndefinedValues) {
    const std::vector<std::string> images = constants({{"black.exr", "0,0,0"}, {"grey.exr", "0.5,0.5,0.5"}});
    const std::string &black = images[0], &grey = images[1];
    const Json equal = compare({black, black})["layers"][0];
    EXPECT_EQ(equal["rel_mse"], 0);
    EXPECT_EQ(equal["mean_ratio"], 1);
    EXPECT_TRUE(equal["undefined"].is_null());
    const Json differing = compare({grey, black})["layers"][0];
    EXPECT_EQ(differing["rmse"], 0.5);
    EXPECT_TRUE(differing["rel_mse"].is_null());
    EXPECT_TRUE(differing["mean_ratio"].is_null());
    EXPECT_EQ(differing["undefined"], "the mean of the reference is 0");
    for (const std::string& image : {black, grey}) {
        result = run_pencil({"compare", image, black});
        EXPECT_EQ(result.out.find("nan"), std::string::npos) << result.out;
        EXPECT_EQ(result.out.find("-: not defined in beauty: the mean of the reference is 0") != std::string::npos, image == grey)
            << result.out;
    }
}

/// The render closes its series where it has converged, the reference sums from order 16 on. A closed room: paths get that long.
TEST_F(Compare, TailsOfRenderAndReference) {
    const std::string scene = PENCIL_SOURCE_DIR "/scenes/furnace.xml", size = "16x16", bright = "albedo=0.8";
    const std::string image = (folder / "image.exr").string(), truth = (folder / "truth.exr").string();
    std::vector<std::string> arguments{"render", scene, "--quiet", "--method", "line", "--resolution", size, "-D", bright, "-o", image};
    arguments.insert(arguments.end(), quick().begin(), quick().end());
    ASSERT_EQ(run_pencil(arguments).code, 0);
    ASSERT_EQ(run_pencil({"reference", scene, "--quiet", "--spp", "64", "--resolution", size, "-D", bright, "-o", truth}).code, 0);
    const Json json = compare({image, truth});
    const auto tail_of = [](const Json& names) {
        for (const std::string name : names)
            if (name.rfind("tail", 0) == 0) return name;
        return std::string();
    };
    const std::string ours = tail_of(json["only_in_image"]);
    ASSERT_FALSE(ours.empty()) << json.dump(1);
    EXPECT_NE(ours, "tail16");
    const std::string last = "bounce" + std::to_string(std::stoi(ours.substr(4)) - 1);
    EXPECT_NE(image_info(image).find(last + ".R"), std::string::npos) << "the tail begins after " << last;
    EXPECT_EQ(tail_of(json["only_in_reference"]), "tail16");
}

TEST_F(Compare, DifferenceImage) {
    const std::vector<std::string> images = two();
    const std::string &a = images[0], &b = images[1];
    const std::string difference = (folder / "d.png").string();
    const Json json = compare({a, b, "--diff", difference});
    EXPECT_EQ(json["difference"]["scale"], 0.1);
    const std::string info = image_info(difference);
    EXPECT_NE(info.find("8 x    6, 3 channel, uint8 png"), std::string::npos) << info;
    EXPECT_NE(info.find("Avg: 104"), std::string::npos) << info;  // nearly the darkest red: 0.1 / sqrt(1.01) of 0.1
}

TEST_F(Compare, NonFinitePixelsAreNamedAndExcluded) {
    const std::string b = constant("b.exr", "1,1,1"), a = (folder / "a.exr").string();
    ASSERT_EQ(run({"oiiotool", "--pattern", "constant:color=inf,1,1", "1x1", "3", b, "--paste", "+5+2", "-o", a}).code, 0);
    const Json json = compare({a, b});
    const Json& beauty = json["layers"][0];
    EXPECT_EQ(beauty["image_non_finite"]["values"], 1) << json.dump(1);
    EXPECT_EQ(beauty["excluded_pixels"], 1);
    EXPECT_EQ(beauty["rmse"], 0);
    EXPECT_NE(result.err.find("channel R at pixel (5, 2)"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("left out of all averages"), std::string::npos) << result.err;
}

TEST_F(Compare, BadInput) {
    const std::vector<std::string> images = constants({{"a.exr", "1,1,1"}, {"b.exr", "1,1,1", "6x8"}});
    const std::string &a = images[0], &b = images[1];
    expect_refused({a, b}, 3, "8x6");
    EXPECT_NE(result.err.find("6x8"), std::string::npos) << result.err;
    expect_refused({a, (folder / "none.exr").string()}, 3, "no such file");
    expect_refused({folder.write("text.exr", "no image"), a}, 3, "not an OpenEXR, PNG or Radiance HDR image");
    expect_refused({folder.write("cut.exr", read_text(a).substr(0, 300)), a}, 3, "damaged");
    expect_refused({a}, 2, "REFERENCE");
    expect_refused({a, a, "--diff", (folder / "d.jpg").string()}, 2, ".exr or .png");
    expect_refused({a, a, "--diff", (folder / "none/d.png").string()}, 6, "does not exist");
    expect_refused({a, a, "--diff", a}, 6, "one of the images");
}

TEST_F(Compare, PngIsComparedAsLinearLight) {
    const std::string a = (folder / "a.png").string(), b = constant("b.exr", "0.2140411,0.2140411,0.2140411");
    ASSERT_EQ(run({"oiiotool", "--pattern", "constant:color=0.5,0.5,0.5", "8x6", "3", "-d", "uint8", "-o", a}).code, 0);
    EXPECT_NEAR(compare({a, b})["layers"][0]["mean_ratio"].get<double>(), 1, 0.01);  // 8 bit
}

}  // namespace
}  // namespace pencil_test
