// Everything of the core: `#include <girth/girth.h>`.
#pragma once

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/geodesic_solver.h"
#include "girth/girth_field.h"
#include "girth/girth_solver.h"
#include "girth/naive_girth.h"
#include "girth/prepare_surface.h"
#include "girth/search_statistics.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"
#include "girth/triangle_soup.h"
