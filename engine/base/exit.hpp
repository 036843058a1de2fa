#pragma once

namespace blossom {

// Exit statuses, the same for all our programs.
enum Exit { done = 0, input_at_fault = 1, wrong_usage = 2, machine_at_fault = 3 };

}  // namespace blossom
