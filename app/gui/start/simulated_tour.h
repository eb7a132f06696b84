// The guided tour on the simulated bridge: the real steps, from connecting to a verified upload, faster than
// time.
#pragma once

#include "app/gui/start/guided_tour.h"

namespace driftbench {

class MainWindow;
class Workbench;

inline constexpr int kTourRuns = 3;

std::vector<TourStep> simulatedTour(MainWindow &window, Workbench &bench);

// A step whose work fails says so; of an acquisition, a training, an upload.
void failWithTheWork(GuidedTour &tour, Workbench &bench);

} // namespace driftbench
