#include "app/session/session_file_state.h"
#include "engine/physics/plan_file.h"

namespace driftbench {

namespace {

constexpr const char *kPlanName = "plan";

} // namespace

Result<std::optional<TestPlan>> SessionFile::plan() const
{
    const auto text = document(kPlanName);
    if (!text)
        return text.error();
    if (!*text)
        return std::optional<TestPlan>();
    auto plan = planFromJson(**text, "the plan in " + path().string());
    if (!plan)
        return plan.error();
    return std::optional<TestPlan>(std::move(*plan));
}

Status SessionFile::setPlan(const TestPlan &plan)
{
    return setDocument(kPlanName, planToJson(plan));
}

Result<std::optional<std::string>> SessionFile::document(const std::string &name) const
{
    Statement rows = database().prepare("SELECT text FROM document WHERE name = ?1");
    const auto row = rows.with(name).step();
    if (!row)
        return row.error();
    return *row ? std::optional<std::string>(rows.text(0)) : std::optional<std::string>();
}

Status SessionFile::setDocument(const std::string &name, const std::string &text)
{
    if (Status allowed = writable(); !allowed)
        return allowed;
    return database().run("INSERT INTO document(name, changed_utc, text) VALUES(?1, ?2, ?3) ON CONFLICT(name)"
                          " DO UPDATE SET changed_utc = excluded.changed_utc, text = excluded.text",
                          name, utcNow(), text);
}

Status SessionFile::removeDocument(const std::string &name)
{
    if (Status allowed = writable(); !allowed)
        return allowed;
    return database().run("DELETE FROM document WHERE name = ?1", name);
}

} // namespace driftbench
