#include "apps/cli/program.h"

int main(int argc, char** argv) {
  return lineservo::apps::run_program(argc, argv);
}
