#include "support/hid_model.h"

#include <algorithm>

namespace driftbench::test {

Status HidModel::plugged()
{
    if (m_callsUntilUnplugged == 0)
        return Error{Errc::DeviceUnplugged, m_identity.product + " was unplugged."};
    if (m_callsUntilUnplugged > 0)
        --m_callsUntilUnplugged;
    return {};
}

Result<std::size_t> HidModel::read(std::span<std::uint8_t> report, std::chrono::milliseconds timeout)
{
    if (const Status ok = plugged(); !ok)
        return ok.error();
    const double untilS = nowS() + std::chrono::duration<double>(timeout).count();
    if (m_input.empty() || m_input.front().readyS > untilS) {
        m_clock.advanceTo(untilS);
        return std::size_t(0);
    }
    const Pending next = m_input.front();
    m_input.pop_front();
    m_clock.advanceTo(next.readyS);
    ++m_reports;
    const std::size_t size = std::min(report.size(), next.report.size());
    std::copy_n(next.report.begin(), size, report.begin());
    return size;
}

Status HidModel::write(std::span<const std::uint8_t> report)
{
    if (const Status ok = plugged(); !ok)
        return ok;
    m_clock.waitS(kFrameS);
    ++m_reports;
    if (report.empty() || report.size() > 65)
        return refused();
    return take(Report(report.begin(), report.end()));
}

Result<std::size_t> HidModel::getFeature(std::span<std::uint8_t> report)
{
    if (const Status ok = plugged(); !ok)
        return ok.error();
    m_clock.waitS(kFrameS);
    ++m_reports;
    Result<Report> got = feature(report[0]);
    if (!got)
        return got.error();
    garble(*got);
    const std::size_t size = std::min(report.size(), got->size());
    std::copy_n(got->begin(), size, report.begin());
    return size;
}

Status HidModel::sendFeature(std::span<const std::uint8_t> report)
{
    if (const Status ok = plugged(); !ok)
        return ok;
    m_clock.waitS(kFrameS);
    ++m_reports;
    return takeFeature(Report(report.begin(), report.end()));
}

void HidModel::answer(Report report, double readyS)
{
    if (m_silent)
        return;
    garble(report);
    m_input.push_back({std::move(report), readyS});
}

// The id stays, or nobody would look at the rest; sometimes the report is cut.
void HidModel::garble(Report &report)
{
    if (!m_garbler)
        return;
    for (std::size_t i = 1; i < report.size(); ++i) {
        if (m_garbler->below(2) == 0)
            report[i] = static_cast<std::uint8_t>(m_garbler->bits());
    }
    if (m_garbler->below(4) == 0)
        report.resize(1 + m_garbler->below(report.size()));
}

std::size_t HidModel::piece(std::size_t most)
{
    return m_splitter && most > 1 ? 1 + m_splitter->below(most) : most;
}

Error HidModel::refused() const
{
    return {Errc::DeviceRefused, m_identity.product + " does not take this report."};
}

} // namespace driftbench::test
