/* The OpenCL functions that TornadoVM's code for the kernel calls, for clang without an OpenCL library. */
typedef unsigned char uchar;
typedef unsigned short ushort;
typedef unsigned int uint;
typedef unsigned long ulong;

#define fma __builtin_fmaf
#define sqrt __builtin_sqrtf
#define rsqrt(x) (1.0f / __builtin_sqrtf(x))
#define fabs __builtin_fabsf
#define fmin __builtin_fminf
#define fmax __builtin_fmaxf
#define isnan __builtin_isnan
#define isless __builtin_isless
#define isequal(x, y) ((x) == (y))
#define min(x, y) ((x) < (y) ? (x) : (y))
#define max(x, y) ((x) > (y) ? (x) : (y))

#if defined(__NVPTX__)
#define SIZE(d) (__nvvm_read_ptx_sreg_ntid_##d() * __nvvm_read_ptx_sreg_nctaid_##d())
#define ID(d) (__nvvm_read_ptx_sreg_ctaid_##d() * __nvvm_read_ptx_sreg_ntid_##d() + __nvvm_read_ptx_sreg_tid_##d())
#else
#define SIZE(d) __builtin_amdgcn_grid_size_##d()
#define ID(d) (__builtin_amdgcn_workgroup_id_##d() * __builtin_amdgcn_workgroup_size_##d() + __builtin_amdgcn_workitem_id_##d())
#endif
#define get_global_size(d) ((d) == 0 ? SIZE(x) : SIZE(y))
#define get_global_id(d) ((d) == 0 ? ID(x) : ID(y))
