// How bad an entry in a session's log is, by its kind.
#pragma once

#include "app/session/session_records.h"

#include <QString>

namespace driftbench {

enum class EventSeverity
{
    Note,
    Warning,
    Problem, // something may be lost
};

EventSeverity severityOf(const SessionEvent &event);

} // namespace driftbench
