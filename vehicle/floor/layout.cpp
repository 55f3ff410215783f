#include "vehicle/floor/layout.h"
