/* ABFLAT_API marks what a shared library exports. While a shared library is compiled,
   ABFLAT_EXPORTS is defined; those who use one need nothing. */
#ifndef ABFLAT_EXPORT_H
#define ABFLAT_EXPORT_H

#if !defined(ABFLAT_EXPORTS)
#define ABFLAT_API
#elif defined(_WIN32)
#define ABFLAT_API __declspec(dllexport)
#else
#define ABFLAT_API __attribute__((visibility("default")))
#endif

#endif
