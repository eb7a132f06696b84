#include "app/session/session_file_state.h"

#include <array>

namespace driftbench {

namespace {

constexpr std::array kGapCauses{GapCause::ReportsLost, GapCause::DeviceOverrun, GapCause::Unplugged,
                                GapCause::Interrupted};

GapCause causeNamed(const std::string &text)
{
    for (const GapCause cause : kGapCauses) {
        if (gapCauseText(cause) == text)
            return cause;
    }
    return GapCause::ReportsLost;
}

std::uint16_t reasonsAt(const Mask &mask, Eigen::Index sample)
{
    std::uint16_t reasons = 0;
    for (const MaskReason reason : kMaskReasons) {
        if (mask.has(sample, reason))
            reasons |= static_cast<std::uint16_t>(reason);
    }
    return reasons;
}

} // namespace

Result<std::vector<RunGap>> SessionFile::gaps(RunId id) const
{
    Statement rows = database().prepare(
        "SELECT before_sample, start_s, end_s, lost_samples, cause FROM gap WHERE run_id = ?1 ORDER BY id");
    rows.with(id);
    std::vector<RunGap> gaps;
    for (;;) {
        const auto row = rows.step();
        if (!row)
            return row.error();
        if (!*row)
            return gaps;
        gaps.push_back(
            {{rows.real(1), rows.real(2), rows.integer(3), causeNamed(rows.text(4))}, rows.integer(0)});
    }
}

Result<std::vector<Exclusion>> SessionFile::exclusions(RunId id) const
{
    Statement rows =
        database().prepare("SELECT start_s, end_s, note FROM exclusion WHERE run_id = ?1 ORDER BY id");
    rows.with(id);
    std::vector<Exclusion> exclusions;
    for (;;) {
        const auto row = rows.step();
        if (!row)
            return row.error();
        if (!*row)
            return exclusions;
        exclusions.push_back({{rows.real(0), rows.real(1)}, rows.text(2)});
    }
}

Status SessionFile::setExclusions(RunId id, const std::vector<Exclusion> &exclusions)
{
    if (Status allowed = writable(); !allowed)
        return allowed;
    if (const auto known = run(id); !known)
        return known.error();
    auto transaction = Transaction::begin(database());
    if (!transaction)
        return transaction.error();
    if (Status removed = database().run("DELETE FROM exclusion WHERE run_id = ?1", id); !removed)
        return removed;
    for (const Exclusion &exclusion : exclusions) {
        if (Status added =
                database().run("INSERT INTO exclusion(run_id, start_s, end_s, note) VALUES(?1, ?2, ?3, ?4)",
                               id, exclusion.range.startS, exclusion.range.endS, exclusion.note);
            !added)
            return added;
    }
    return transaction->commit();
}

Result<std::optional<Mask>> SessionFile::mask(RunId id) const
{
    const auto transaction = Transaction::beginReading(database());
    if (!transaction)
        return transaction.error();
    const auto known = run(id);
    if (!known)
        return known.error();
    const auto set = database().integer("SELECT count(*) FROM mask WHERE run_id = ?1", id);
    if (!set)
        return set.error();
    if (*set == 0)
        return std::optional<Mask>();
    Mask mask(known->samples);
    Statement rows =
        database().prepare("SELECT first_sample, samples, reasons FROM mask_range WHERE run_id = ?1");
    rows.with(id);
    for (;;) {
        const auto row = rows.step();
        if (!row)
            return row.error();
        if (!*row)
            return std::optional<Mask>(std::move(mask));
        const std::int64_t first = rows.integer(0);
        const std::int64_t count = rows.integer(1);
        if (first < 0 || count < 0 || first > mask.size() || count > mask.size() - first)
            return Error{Errc::SessionDamaged, database().path().string() + ", run \"" +
                                                   known->description.name +
                                                   "\": its mask reaches beyond its samples. Set it anew."};
        for (const MaskReason reason : kMaskReasons) {
            if ((rows.integer(2) & static_cast<std::int64_t>(reason)) == 0)
                continue;
            for (std::int64_t sample = first; sample < first + count; ++sample)
                mask.set(sample, reason);
        }
    }
}

Status SessionFile::setMask(RunId id, const Mask &mask)
{
    if (Status allowed = writable(); !allowed)
        return allowed;
    const auto known = run(id);
    if (!known)
        return known.error();
    if (mask.size() != known->samples)
        return Error{Errc::InvalidOption, "The mask has " + std::to_string(mask.size()) +
                                              " samples and run \"" + known->description.name + "\" has " +
                                              std::to_string(known->samples) + "; give a mask of the run."};
    auto transaction = Transaction::begin(database());
    if (!transaction)
        return transaction.error();
    if (Status removed = database().run("DELETE FROM mask WHERE run_id = ?1", id); !removed)
        return removed;
    if (Status added = database().run("INSERT INTO mask(run_id, samples) VALUES(?1, ?2)", id, mask.size());
        !added)
        return added;
    Statement insert = database().prepare(
        "INSERT INTO mask_range(run_id, first_sample, samples, reasons) VALUES(?1, ?2, ?3, ?4)");
    for (Eigen::Index first = 0, end = 0; first < mask.size(); first = end) {
        const std::uint16_t reasons = reasonsAt(mask, first);
        for (end = first + 1; end < mask.size() && reasonsAt(mask, end) == reasons; ++end) {
        }
        if (reasons == 0)
            continue;
        if (Status added = insert.with(id, first, end - first, std::uint32_t{reasons}).run(); !added)
            return added;
    }
    return transaction->commit();
}

} // namespace driftbench
