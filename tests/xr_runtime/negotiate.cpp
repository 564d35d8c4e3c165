// SPDX-License-Identifier: Apache-2.0
// The library's one door: the loader asks here for all the rest.
#include "runtime.hpp"

#include <cstring>

namespace {

using feelem::xr_runtime::Entry;

// The loader's own header is not packaged; these are its two structures, version 1.
struct LoaderInfo {
    std::int32_t type;
    std::uint32_t version;
    std::size_t bytes;
    std::uint32_t lowest_interface, highest_interface;
    XrVersion lowest_api, highest_api;
};

struct RuntimeRequest {
    std::int32_t type;
    std::uint32_t version;
    std::size_t bytes;
    std::uint32_t interface_version;
    XrVersion api_version;
    PFN_xrGetInstanceProcAddr get_instance_proc_addr;
};

XrResult get_proc(XrInstance, const char* name, PFN_xrVoidFunction* out) {
    namespace runtime = feelem::xr_runtime;
    if (std::strcmp(name, "xrGetInstanceProcAddr") == 0) {
        *out = reinterpret_cast<PFN_xrVoidFunction>(&get_proc);
        return XR_SUCCESS;
    }
    for (const auto calls :
         {runtime::instance_calls(),
          runtime::session_calls(),
          runtime::frame_calls(),
          runtime::swapchain_calls(),
          runtime::action_calls(),
          runtime::input_calls(),
          runtime::haptic_calls(),
          runtime::space_calls()})
        for (const Entry& each : calls)
            if (std::strcmp(each.name, name) == 0) {
                *out = each.function;
                return XR_SUCCESS;
            }
    *out = nullptr;
    return XR_ERROR_FUNCTION_UNSUPPORTED;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) XrResult xrNegotiateLoaderRuntimeInterface(
    const LoaderInfo* loader, RuntimeRequest* request
) {
    constexpr std::int32_t kLoaderInfo = 1, kRuntimeRequest = 3;
    const bool is_known = loader && request && loader->type == kLoaderInfo &&
                          request->type == kRuntimeRequest && loader->lowest_interface <= 1 &&
                          loader->highest_interface >= 1;
    if (!is_known) return XR_ERROR_INITIALIZATION_FAILED;
    request->interface_version = 1;
    request->api_version = XR_MAKE_VERSION(1, 0, 20);
    request->get_instance_proc_addr = get_proc;
    return XR_SUCCESS;
}
