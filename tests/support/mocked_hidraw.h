// A simulated board as libhidapi finds it on a computer that has none: sysfs, node and ioctls of a USB device
// with hidraw, by umockdev. Unmodified hidapi enumerates, opens, reads and asks it, and below it the
// reference firmware answers.
//
// A program that uses this must run with umockdev's library preloaded, as the test's ENVIRONMENT in
// tests/CMakeLists.txt has it.
//
// What it is not: the kernel. A reader that sleeps makes the device keep its reports instead of losing them
// to a ring of 64, and there are no output reports, of which the native bridge has none.
#pragma once

#include "device/simulated_board.h"

#include <memory>
#include <string>

namespace driftbench::test {

class MockedHidraw
{
public:
    // Plugged in; the board must have a speed, as libhidapi waits in real time.
    explicit MockedHidraw(std::shared_ptr<SimulatedBoard> board);
    ~MockedHidraw();
    MockedHidraw(const MockedHidraw &) = delete;
    MockedHidraw &operator=(const MockedHidraw &) = delete;

    static bool isPreloaded();

    void unplug(); // the board as well; also after a fault that unplugged it
    void plugIn(); // as a node with the next number
    // What the kernel says of every exchange that fails from now on, until it is plugged in again. Else EPIPE
    // for a refusal and ENODEV for the device's end; a real one also has EIO for both.
    void failWith(int errorNumber);
    std::string node() const; // "/dev/hidraw0", the one of the last time it was plugged in

private:
    struct Port; // one time plugged in

    std::shared_ptr<SimulatedBoard> m_board;
    std::unique_ptr<Port> m_port;
};

} // namespace driftbench::test
