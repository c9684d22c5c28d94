// Everything of the library girth::study: `#include <girth/study/study.h>`. It repeats the studies
// of the paper: the naive method, robustness (section 5), and the retrieval of shapes
// (section 6.1), with tables and pages of what came out.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include "girth/study/bag_of_features.h"
#include "girth/study/descriptor_rows.h"
#include "girth/study/histogram.h"
#include "girth/study/joint_histogram.h"
#include "girth/study/measures.h"
#include "girth/study/naive_girth.h"
#include "girth/study/pair_distances.h"
#include "girth/study/robustness.h"
#include "girth/study/signatures.h"
#include "girth/study/study_fields.h"
#include "girth/study/surface_changes.h"
#include "girth/study/tip_stability.h"
#include "girth/study/transport.h"
#include "girth/study/write_robustness.h"
#include "girth/study/write_study.h"
#include "girth/study/write_tip_trials.h"
