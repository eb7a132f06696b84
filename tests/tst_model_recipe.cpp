#include "engine/models/model_recipe.h"
#include "support/model_data.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <set>

using namespace driftbench;

class TestModelRecipe : public QObject
{
    Q_OBJECT

private slots:
    void names_defaults_areKnown();
    void modelRecipes_everyName_ranksSimplicity();
    void modelRecipes_nameTwice_isRefused();
    void modelRecipes_unknownName_listsTheKnown();
    void fit_everyRecipe_modelAndFiguresPerAxis();
    void fit_nothingUsable_saysSo();
    void fit_hookStops_cancelled();
};

static Eigen::Vector3d wave(double d)
{
    return {0.5 * std::sin(d / 20.0), 0.01 * d, 1.0};
}

static TrainingSet campaign()
{
    return {{test::makeRamp("run1", 5000, 0.0, 60.0, wave), test::makeRamp("run2", 4000, 5.0, 60.0, wave)},
            20.0};
}

void TestModelRecipe::names_defaults_areKnown()
{
    const std::set<std::string> known(knownModelNames().begin(), knownModelNames().end());
    QCOMPARE(known.size(), knownModelNames().size());
    for (const std::string &name : defaultModelNames())
        QVERIFY(known.count(name) == 1);
    QVERIFY(std::find(defaultModelNames().begin(), defaultModelNames().end(), "cubic-ardupilot") ==
            defaultModelNames().end());
}

void TestModelRecipe::modelRecipes_everyName_ranksSimplicity()
{
    // Networks by least squares count as simpler than one by descent.
    const std::vector<std::string> simplestFirst{"constant", "linear",    "cubic", "cubic-ardupilot",
                                                 "rbf",      "rbf-paper", "bpnn"};
    const auto recipes = modelRecipes(simplestFirst, {});
    QVERIFY(recipes.ok());
    QCOMPARE(recipes->size(), knownModelNames().size());
    for (std::size_t i = 0; i < recipes->size(); ++i) {
        QCOMPARE((*recipes)[i].name, simplestFirst[i]);
        QVERIFY(i == 0 || (*recipes)[i].complexity > (*recipes)[i - 1].complexity);
    }
}

void TestModelRecipe::modelRecipes_nameTwice_isRefused()
{
    const auto recipes = modelRecipes({"linear", "cubic", "linear"}, {});
    QVERIFY(!recipes.ok());
    QCOMPARE(recipes.error().code, Errc::InvalidOption);
    QVERIFY(recipes.error().message.find("'linear'") != std::string::npos);
}

void TestModelRecipe::modelRecipes_unknownName_listsTheKnown()
{
    const auto recipes = modelRecipes({"linear", "spline"}, {});
    QVERIFY(!recipes.ok());
    QCOMPARE(recipes.error().code, Errc::InvalidOption);
    QVERIFY(recipes.error().message.find("'spline'") != std::string::npos);
    for (const std::string &name : knownModelNames())
        QVERIFY(recipes.error().message.find(name) != std::string::npos);
}

void TestModelRecipe::fit_everyRecipe_modelAndFiguresPerAxis()
{
    const auto recipes = modelRecipes(knownModelNames(), {});
    QVERIFY(recipes.ok());
    const std::map<std::string, std::string> figure{
        {"constant", "bias_y_dps"},   {"linear", "slope_y_dps_per_c"},
        {"cubic", "c3_y_dps_per_c3"}, {"cubic-ardupilot", "c0_y_dps"},
        {"bpnn", "loss_y_dps2"},      {"rbf-paper", "centres_y"},
        {"rbf", "centres_y"}};
    for (const ModelRecipe &recipe : *recipes) {
        const auto fitted = recipe.fit(campaign(), {});
        QVERIFY2(fitted.ok(), recipe.name.c_str());
        QVERIFY(fitted->summary.count(figure.at(recipe.name)) == 1);
        QCOMPARE(fitted->rbf.has_value(), recipe.name.rfind("rbf", 0) == 0);
        const Eigen::VectorXd deltaT = Eigen::VectorXd::LinSpaced(20, 0.0, 60.0);
        QVERIFY(predictAtDeltaT(fitted->model, deltaT).allFinite());
    }
}

void TestModelRecipe::fit_nothingUsable_saysSo()
{
    const auto recipes = modelRecipes(knownModelNames(), {});
    QVERIFY(recipes.ok());
    const TrainingSet empty{{test::makeRun("empty", {}, {}, {})}, 0.0};
    for (const ModelRecipe &recipe : *recipes) {
        const auto fitted = recipe.fit(empty, {});
        QVERIFY(!fitted.ok());
        QCOMPARE(fitted.error().code, Errc::NothingUsable);
    }
}

void TestModelRecipe::fit_hookStops_cancelled()
{
    const auto recipes = modelRecipes(knownModelNames(), {});
    QVERIFY(recipes.ok());
    for (const ModelRecipe &recipe : *recipes) {
        const auto fitted = recipe.fit(campaign(), [](const Progress &) { return Flow::Stop; });
        QVERIFY(!fitted.ok());
        QCOMPARE(fitted.error().code, Errc::Cancelled);
    }
}

QTEST_APPLESS_MAIN(TestModelRecipe)
#include "tst_model_recipe.moc"
