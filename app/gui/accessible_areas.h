// What a screen reader is told of scroll areas. Qt's own answer to "the child number n" of an area does not
// look whether there is one (6.4: QAccessibleAbstractScrollArea::child): where a scroll bar goes while a
// reader walks through the window, the program ends. This one does, and has the same children.
#pragma once

namespace driftbench {

// For the whole program, once it has a QApplication. A second call changes nothing.
void installAccessibleAreas();

} // namespace driftbench
