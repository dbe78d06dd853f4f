// SPDX-License-Identifier: MIT
// HLSL to SPIR-V by DXC's library: dxc <libdxcompiler.so> <in.hlsl> <out.spv> [option...]
#define _GNU_SOURCE 1
#include <dlfcn.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "WinAdapter.h"
#include "dxcapi.h"

int main(int count, char** arguments) {
    void* library = count < 4 ? nullptr : dlopen(arguments[1], RTLD_NOW);
    if (library == nullptr) {
        std::fprintf(stderr, "dxc: %s\n", count < 4 ? "library, source and output?" : dlerror());
        return 2;
    }
    const auto create = reinterpret_cast<DxcCreateInstanceProc>(dlsym(library, "DxcCreateInstance"));
    CComPtr<IDxcCompiler3> compiler;
    if (create == nullptr ||
        create(CLSID_DxcCompiler, __uuidof(IDxcCompiler3), reinterpret_cast<void**>(&compiler)) != S_OK) {
        std::fprintf(stderr, "dxc: no compiler in %s\n", arguments[1]);
        return 2;
    }
    std::ifstream file(arguments[2], std::ios::binary);
    const std::string source((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    std::vector<std::wstring> options;
    for (int i = 4; i < count; ++i) {
        options.emplace_back(arguments[i], arguments[i] + std::char_traits<char>::length(arguments[i]));
    }
    std::vector<const wchar_t*> pointers;
    for (const std::wstring& option : options) {
        pointers.push_back(option.c_str());
    }
    const DxcBuffer buffer{source.data(), source.size(), CP_UTF8};
    CComPtr<IDxcResult> result;
    compiler->Compile(&buffer, pointers.data(), static_cast<UINT32>(pointers.size()), nullptr,
                      __uuidof(IDxcResult), reinterpret_cast<void**>(&result));
    HRESULT status = E_FAIL;
    result->GetStatus(&status);
    CComPtr<IDxcBlobUtf8> said;
    result->GetOutput(DXC_OUT_ERRORS, __uuidof(IDxcBlobUtf8), reinterpret_cast<void**>(&said), nullptr);
    if (said != nullptr && said->GetStringLength() != 0) {
        std::fprintf(stderr, "%s\n", said->GetStringPointer());
    }
    if (status != S_OK) {
        return 1;
    }
    CComPtr<IDxcBlob> module;
    result->GetOutput(DXC_OUT_OBJECT, __uuidof(IDxcBlob), reinterpret_cast<void**>(&module), nullptr);
    std::ofstream(arguments[3], std::ios::binary)
        .write(static_cast<const char*>(module->GetBufferPointer()),
               static_cast<std::streamsize>(module->GetBufferSize()));
    return 0;
}
