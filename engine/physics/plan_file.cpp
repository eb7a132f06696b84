#include "engine/physics/plan_file.h"

#include "engine/base/atomic_file.h"
#include "engine/base/text.h"

#include <cassert>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

namespace driftbench {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char *kFormat = "driftbench plan";
constexpr std::uintmax_t kLargestFile = 1U << 20U; // bytes
constexpr int kMostCount = 1000000;                // what checkTestPlan allows is less

Error damaged(const std::string &name, const std::string &clause)
{
    return {Errc::PlanDamaged, "The plan file '" + name + "' " + clause +
                                   "; mend it or write it anew with `driftbench-cli plan --out`."};
}

// One field after another; the first problem is kept, as a clause such as "sensor.range_dps is missing".
class Fields
{
public:
    Fields(const Json &object, std::string path, std::string &problem)
        : m_object(object), m_path(std::move(path)), m_problem(problem)
    {
    }

    void read(const char *key, double &value) const
    {
        const Json *found = find(key);
        if (found != nullptr && found->is_number())
            value = found->get<double>();
        else
            fail(key, "is not a number");
    }
    void read(const char *key, int &value) const
    {
        const Json *found = find(key);
        if (found != nullptr && found->is_number_unsigned() && found->get<std::uint64_t>() <= kMostCount)
            value = found->get<int>();
        else
            fail(key, "is not a whole number");
    }
    void read(const char *key, std::string &value) const
    {
        const Json *found = find(key);
        if (found != nullptr && found->is_string())
            value = found->get<std::string>();
        else
            fail(key, "is not a text");
    }
    Fields child(const char *key) const
    {
        static const Json nothing = Json::object();
        const Json *found = find(key);
        if (found == nullptr || !found->is_object())
            fail(key, "is not an object");
        const bool there = found != nullptr && found->is_object();
        return {there ? *found : nothing, m_path + key + ".", m_problem};
    }
    void fail(const char *key, const std::string &clause) const
    {
        if (m_problem.empty())
            m_problem = m_path + key + " " + clause;
    }

private:
    const Json *find(const char *key) const
    {
        const auto found = m_object.find(key);
        if (found != m_object.end())
            return &*found;
        fail(key, "is missing");
        return nullptr;
    }

    const Json &m_object;
    std::string m_path;
    std::string &m_problem;
};

// What is written and what is read name the same fields in the same order.
template <class Visit>
void visitSensor(auto &sensor, const Visit &visit)
{
    visit("model", sensor.model);
    visit("sensitivity_mdps", sensor.sensitivityMdps);
    visit("range_dps", sensor.rangeDps);
    visit("zero_rate_change_mdps_per_C", sensor.zeroRateChangeMdpsPerC);
    visit("zero_rate_change_range_dps", sensor.zeroRateChangeRangeDps);
    visit("sensitivity_change_percent", sensor.sensitivityChangePercent);
    visit("noise_density_dps_per_root_Hz", sensor.noiseDensityDpsPerRootHz);
    visit("lowest_C", sensor.lowestC);
    visit("highest_C", sensor.highestC);
}

template <class Visit>
void visitChamber(auto &chamber, const Visit &visit)
{
    visit("model", chamber.model);
    visit("edge_m", chamber.edgeM);
    visit("specific_heat_J_per_kg_K", chamber.specificHeatJPerKgK);
    visit("density_kg_per_m3", chamber.densityKgPerM3);
    visit("conductivity_W_per_m_K", chamber.conductivityWPerMK);
    visit("thermometer_accuracy_C", chamber.thermometerAccuracyC);
}

template <class Visit>
void visitRun(auto &plan, const Visit &visit)
{
    visit("lowest_C", plan.lowestC);
    visit("highest_C", plan.highestC);
    visit("step_C", plan.stepC);
    visit("period_s", plan.periodS);
    visit("hold_s", plan.holdS);
    visit("sample_rate_Hz", plan.sampleRateHz);
    visit("cycles", plan.cycles);
    visit("runs", plan.runs);
}

Result<TestPlan> planFrom(const Json &document, const std::string &name)
{
    std::string problem;
    const Fields fields(document, "", problem);
    TestPlan plan;
    std::string kind;
    fields.read("kind", kind);
    const auto named = planKindNamed(kind);
    if (!named)
        fields.fail("kind", "is none of heating, cooling and cycle");
    const auto into = [](const Fields &of) {
        return [of](const char *key, auto &value) { of.read(key, value); };
    };
    visitRun(plan, into(fields));
    visitSensor(plan.sensor, into(fields.child("sensor")));
    visitChamber(plan.chamber, into(fields.child("chamber")));
    if (!problem.empty())
        return damaged(name, "is damaged: " + problem);
    plan.kind = *named;
    if (const Status ok = checkTestPlan(plan); !ok)
        return Error{Errc::PlanDamaged, "The plan file '" + name + "' can't be run: " + ok.error().message};
    return plan;
}

Result<std::string> contentOf(const std::filesystem::path &file)
{
    const std::string name = file.string();
    std::error_code code;
    if (!std::filesystem::exists(file, code))
        return Error{Errc::FileNotFound, "There is no plan file '" + name + "'; check its name and folder."};
    const std::uintmax_t size = std::filesystem::file_size(file, code);
    if (code)
        return Error{Errc::FileUnreadable, "The plan file '" + name + "' can't be read (" + code.message() +
                                               "); check that it is a file and its permissions."};
    if (size > kLargestFile)
        return damaged(name, "is larger than any plan");
    std::ifstream stream(file, std::ios::binary);
    std::string content((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    if (!stream.is_open() || stream.bad())
        return Error{Errc::FileUnreadable,
                     "The plan file '" + name + "' can't be read; check its permissions."};
    return content;
}

// Multiples of 0.1 °C are not quite that in binary; a controller is spared the digits.
std::string forController(double value)
{
    constexpr double kPartsPerUnit = 1e6;
    return shortest(std::round(value * kPartsPerUnit) / kPartsPerUnit);
}

} // namespace

std::string planToJson(const TestPlan &plan)
{
    const auto into = [](Json &object) {
        return [&object](const char *key, const auto &value) { object[key] = value; };
    };
    Json sensor = Json::object();
    visitSensor(plan.sensor, into(sensor));
    Json chamber = Json::object();
    visitChamber(plan.chamber, into(chamber));
    Json document{
        {"format", kFormat}, {"version", kPlanFormatVersion}, {"kind", std::string(planKindName(plan.kind))}};
    visitRun(plan, into(document));
    document["sensor"] = std::move(sensor);
    document["chamber"] = std::move(chamber);
    // Names given by the user need not be valid UTF-8; JSON must be.
    return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<TestPlan> planFromJson(std::string_view json, const std::string &name)
{
    Json document;
    try {
        document = Json::parse(json.begin(), json.end());
    } catch (const Json::parse_error &error) {
        if (error.byte > json.size())
            return damaged(name, "is cut off after " + std::to_string(json.size()) + " bytes");
        return damaged(name, "is not JSON at byte " + std::to_string(error.byte));
    } catch (const Json::exception &) {
        return damaged(name, "holds a number that is out of range");
    }
    if (!document.is_object() || document.value("format", Json()) != kFormat)
        return damaged(name,
                       "is not a Driftbench plan (its field format is not \"" + std::string(kFormat) + "\")");
    const Json version = document.value("version", Json());
    if (!version.is_number_unsigned() || version.get<std::uint64_t>() == 0)
        return damaged(name, "is damaged: version is not a whole number from 1 on");
    if (version.get<std::uint64_t>() > kPlanFormatVersion)
        return Error{Errc::PlanDamaged, "The plan file '" + name +
                                            "' was written by a newer Driftbench; update, or write it anew "
                                            "with this version."};
    return planFrom(document, name);
}

Status writePlan(const TestPlan &plan, const std::filesystem::path &file)
{
    return writeFileAtomically(file, planToJson(plan));
}

Result<TestPlan> readPlan(const std::filesystem::path &file)
{
    const Result<std::string> content = contentOf(file);
    if (!content)
        return content.error();
    return planFromJson(*content, file.string());
}

std::string planStepsToCsv(const TestPlan &plan)
{
    const auto profile = plan.profile();
    assert(profile.ok());
    const std::vector<ProfileStep> &steps = profile->steps();
    std::string text = "step,start_s,duration_s,setpoint_C\n";
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const double endS = i + 1 < steps.size() ? steps[i + 1].startS : profile->durationS();
        text += std::to_string(i + 1) + "," + forController(steps[i].startS) + "," +
                forController(endS - steps[i].startS) + "," + forController(steps[i].setpointC) + "\n";
    }
    return text;
}

std::string planSegmentsToCsv(const TestPlan &plan)
{
    std::string text = "segment,kind,start_s,duration_s,from_C,to_C,rate_C_per_min\n";
    int number = 0;
    for (const PlanSegment &segment : plan.segments()) {
        text += std::to_string(++number) + (segment.isHold() ? ",hold," : ",ramp,") +
                forController(segment.startS) + "," + forController(segment.durationS) + "," +
                forController(segment.fromC) + "," + forController(segment.toC) + "," +
                forController(segment.rateCPerMin()) + "\n";
    }
    return text;
}

} // namespace driftbench
