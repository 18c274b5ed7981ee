// What the experiment's page and its JSON say, and the words and pictures that they are made of.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "converge/pictures.h"
#include "converge/report.h"
#include "converge/run_plan.h"
#include "converge/text.h"
#include "unit/run_points.h"

namespace pencil {
namespace {

Report small_report() {
    Report report;
    report.options.scene = "<b>&\"'.xml";
    report.options.methods = {"sets"};
    report.options.width = report.options.height = 4;
    report.options.folder = "/nonexistent";
    report.truth.width = report.truth.height = 4;
    report.truth.rgb.assign(48, 0.5F);
    constexpr double noise = 1e-5;  // of the reference, a part of every error
    report.truth.noise_rel_mse = noise;
    report.finished = true;
    for (int budget = 0; budget < 6; ++budget) {
        report.points.push_back(
            point(path_tracer_name, budget, 0, path_tracer_seconds(budget), 1e-3 / path_tracer_seconds(budget) + noise));
        report.points.push_back(point("sets", budget, 0, 0.3 * std::pow(2, budget), 0.002 + noise));
    }
    report.methods = summarise(report.points, report.options, report.truth);
    return report;
}

TEST(Report, JsonHoldsNumbersAndReasons) {
    const nlohmann::json json = nlohmann::json::parse(summary_json(small_report()));
    EXPECT_EQ(json["schema"], 1);
    ASSERT_EQ(json["methods"].size(), 2U);
    EXPECT_NEAR(json["methods"][0]["fits"]["relative_error"]["slope"].get<double>(), -0.5, 1e-6);
    EXPECT_FALSE(json["methods"][0]["fits"]["relative_error"]["floor_visible"].get<bool>());
    EXPECT_TRUE(json["methods"][1]["fits"]["relative_error"]["floor_visible"].get<bool>());
    EXPECT_NEAR(json["methods"][1]["fits"]["relative_error"]["floor"].get<double>(), std::sqrt(0.002), 1e-6);
    const nlohmann::json& at_a_second = json["comparison"]["relative_error"]["equal_time"][1];
    EXPECT_EQ(at_a_second["seconds"], 1);
    EXPECT_EQ(at_a_second["ahead"], "path-tracer");
    EXPECT_NEAR(at_a_second["lead"].get<double>(), std::sqrt(2), 1e-6);
    const nlohmann::json& early = json["comparison"]["relative_error"]["equal_time"][0]["errors"]["sets"];
    EXPECT_TRUE(early["value"].is_null());
    EXPECT_EQ(early["state"], "before first point");
    EXPECT_NEAR(early["first_seconds"].get<double>(), 0.3, 1e-12);
}

TEST(Report, PageSaysWhoIsAhead) {
    const std::string html = page_html(small_report(), "no plots (reason); advice");
    EXPECT_NE(html.find("<h1>Error against run time: &lt;b&gt;&amp;&quot;&apos;.xml</h1>"), std::string::npos);
    EXPECT_EQ(html.find("<b>&"), std::string::npos);
    EXPECT_EQ(html.find("{{"), std::string::npos) << "a tag that is not filled";
    EXPECT_NE(html.find("ahead of sets"), std::string::npos);
    EXPECT_NE(html.find("no image yet"), std::string::npos);
    EXPECT_NE(html.find("not reached"), std::string::npos);
    EXPECT_NE(html.find("no plots (reason); advice"), std::string::npos);
    for (const char* resource : {"http:", "https:", "src=\"/", "url(", "<script", "<link"})
        EXPECT_EQ(html.find(resource), std::string::npos) << resource;
}

TEST(Report, PageOfAnUnfinishedMeasurement) {
    Report report = small_report();
    report.finished = false;
    report.warnings = {"noise > signal", "again"};
    const auto has = [&](const std::string& text) { return page_html(report, "").find(text) != std::string::npos; };
    EXPECT_TRUE(has("interrupted after 12 runs"));
    EXPECT_TRUE(has("<li>noise &gt; signal</li>\n<li>again</li>"));
    EXPECT_TRUE(has("Its own noise is about relMSE 1.0e-05 (0.32\u00a0%)."));
    EXPECT_FALSE(has("No run is finished yet."));
    report.methods.clear();
    report.warnings.clear();
    report.truth.noise_rel_mse.reset();
    EXPECT_TRUE(has("No run is finished yet."));
    EXPECT_TRUE(has("Its own noise is not known."));
    EXPECT_FALSE(has("<section>\n<h2>Images"));
    EXPECT_FALSE(has("<ul"));
}

TEST(Report, CardsNameTheMetricsThatDisagree) {
    Report report = small_report();
    EXPECT_EQ(page_html(report, "").find("by RMSE"), std::string::npos);
    for (RunPoint& run : report.points) run.rmse = run.method == "sets" ? 0.01 : 0.04;
    report.methods = summarise(report.points, report.options, report.truth);
    EXPECT_NE(page_html(report, "").find("by RMSE, sets is ahead of it by 4"), std::string::npos);
}

TEST(Report, WarnsOfWhatTheCurvesDoNotShow) {
    Report report = small_report();
    EXPECT_TRUE(run_warnings(report).empty());
    report.truth.noise_rel_mse = 2e-4;  // beside 1e-4 that is left
    ASSERT_EQ(run_warnings(report).size(), 1U);
    EXPECT_NE(run_warnings(report)[0].find("noise of the reference"), std::string::npos);
    report.truth.noise_rel_mse.reset();
    report.methods[1].budgets.resize(3);
    ASSERT_EQ(run_warnings(report).size(), 1U);
    EXPECT_NE(run_warnings(report)[0].find("sets has 3 points"), std::string::npos);
    report.finished = false;
    EXPECT_TRUE(run_warnings(report).empty());
    report.host_threads = 2;
    report.points[3].load = 17;
    ASSERT_EQ(run_warnings(report).size(), 1U);
    EXPECT_NE(run_warnings(report)[0].find("load 17 on 2 cores"), std::string::npos);
}

TEST(Text, NumbersAreShort) {
    EXPECT_EQ(round_text(0.01234), "0.012");
    EXPECT_EQ(round_text(4.25), "4.2");
    EXPECT_EQ(round_text(42.4), "42");
    EXPECT_EQ(round_text(1234), "1234");
    EXPECT_EQ(round_text(0.000012), "1.2e-05");
    EXPECT_EQ(round_text(NAN), "–");
    EXPECT_EQ(percent_text(0.042), "4.2\u00a0%");
}

TEST(Pictures, DataUris) {
    EXPECT_EQ(data_uri("a/b", ""), "data:a/b;base64,");
    EXPECT_EQ(data_uri("a/b", "f"), "data:a/b;base64,Zg==");  // RFC 4648, section 10
    EXPECT_EQ(data_uri("a/b", "fo"), "data:a/b;base64,Zm8=");
    EXPECT_EQ(data_uri("a/b", "foo"), "data:a/b;base64,Zm9v");
    EXPECT_EQ(data_uri("a/b", "foobar"), "data:a/b;base64,Zm9vYmFy");
    EXPECT_EQ(data_uri("a/b", "\xff\xef"), "data:a/b;base64,/+8=");
    EXPECT_EQ(picture_uri(std::vector<float>(12, 0.5F), 2, 2, 1).rfind("data:image/png;base64,iVBORw0KGgo", 0), 0U);
}

}  // namespace
}  // namespace pencil
