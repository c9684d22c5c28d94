// CLI11's app, declared for headers that pass it by reference only.
#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's own
class App;
}
