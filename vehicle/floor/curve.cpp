#include "vehicle/floor/curve.h"
