// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <ctime>

/// What a peer written in C++ gets and fills; the benchmark passes NumPy's arrays through ctypes.
struct PeerMesh {
    float* points;           ///< 3 per vertex; overwritten by the result
    std::uint32_t* corners;  ///< 3 per face; overwritten by the result
    std::size_t pointCount;  ///< in: vertices of the input; out: vertices of the result
    std::size_t faceCount;   ///< in: faces of the input; out: faces of the result
    std::size_t targetFaces; ///< faces to reach
    double cpuSeconds;       ///< out: processor time of the simplification alone, all threads
    double wallSeconds;      ///< out: elapsed time of the simplification alone
};

/// Adds the time between its construction and destruction to a mesh's figures.
class PeerTimer
{
  public:
    explicit PeerTimer(PeerMesh& mesh)
        : mesh_(mesh), cpuStart_(Seconds(CLOCK_PROCESS_CPUTIME_ID)), wallStart_(Seconds(CLOCK_MONOTONIC))
    {
    }
    PeerTimer(const PeerTimer&) = delete;
    PeerTimer& operator=(const PeerTimer&) = delete;
    ~PeerTimer()
    {
        mesh_.cpuSeconds = Seconds(CLOCK_PROCESS_CPUTIME_ID) - cpuStart_;
        mesh_.wallSeconds = Seconds(CLOCK_MONOTONIC) - wallStart_;
    }

  private:
    static double Seconds(clockid_t clock)
    {
        timespec now{};
        clock_gettime(clock, &now);
        return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
    }

    PeerMesh& mesh_;
    double cpuStart_;
    double wallStart_;
};
