/* SPDX-License-Identifier: MIT */
/** @file truckride/truckride.h  Every public header. */
#ifndef TRUCKRIDE_TRUCKRIDE_H
#define TRUCKRIDE_TRUCKRIDE_H

#include <truckride/base.h>
#include <truckride/curve.h>
#include <truckride/series.h>
#include <truckride/spectrum.h>
#include <truckride/signal.h>
#include <truckride/files.h>
#include <truckride/crg.h>
#include <truckride/road.h>
#include <truckride/law.h>
#include <truckride/spec.h>
#include <truckride/frame.h>
#include <truckride/vehicle.h>
#include <truckride/model.h>
#include <truckride/excitation.h>
#include <truckride/newmark.h>
#include <truckride/rungekutta.h>
#include <truckride/linear.h>
#include <truckride/reduce.h>
#include <truckride/simulate.h>
#include <truckride/comfort.h>
#include <truckride/roughness.h>
#include <truckride/batch.h>
#include <truckride/calibrate.h>
#include <truckride/study.h>
#include <truckride/modelfile.h>

#endif
