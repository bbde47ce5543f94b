// Embree 3 with single rays and with packets of eight, as its manual says: subnormal numbers off, a context of its own. The
// peer is given the same bytes as scn's rays; its answers are counted and summed so that no work can
// be left out.

#include <embree3/rtcore.h>
#include <pmmintrin.h>
#include <time.h>
#include <xmmintrin.h>

#include <cstddef>
#include <cstring>

namespace {

struct Ray {
    float origin[3], direction[3], t_max;
};

// Embree asks for these; scn's rays are traced without them.
class NoSubnormals {
public:
    NoSubnormals() : before(_mm_getcsr()) {
        _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
        _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
    }
    ~NoSubnormals() { _mm_setcsr(before); }

private:
    unsigned before;
};

void set(RTCRay& to, const Ray& from) {
    to.org_x = from.origin[0];
    to.org_y = from.origin[1];
    to.org_z = from.origin[2];
    to.dir_x = from.direction[0];
    to.dir_y = from.direction[1];
    to.dir_z = from.direction[2];
    to.tnear = 0;
    to.tfar = from.t_max;
    to.time = 0;
    to.mask = -1;
    to.flags = 0;
}

const size_t WIDTH = 8;

// Up to eight rays, and which of the lanes have one.
void set(RTCRay8& to, int* valid, const Ray* from, size_t left) {
    for (size_t k = 0; k < WIDTH; ++k) {
        valid[k] = k < left ? -1 : 0;
        const Ray& ray = from[k < left ? k : 0];
        to.org_x[k] = ray.origin[0];
        to.org_y[k] = ray.origin[1];
        to.org_z[k] = ray.origin[2];
        to.dir_x[k] = ray.direction[0];
        to.dir_y[k] = ray.direction[1];
        to.dir_z[k] = ray.direction[2];
        to.tnear[k] = 0;
        to.tfar[k] = ray.t_max;
        to.time[k] = 0;
        to.mask[k] = -1;
        to.flags[k] = 0;
    }
}

}  // namespace

extern "C" {

// Seconds of the processor this thread has had.
double peer_seconds() {
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return now.tv_sec + 1e-9 * now.tv_nsec;
}

void* peer_build(const float* points, size_t of_points, const unsigned* faces, size_t of_faces,
                 int robust) {
    NoSubnormals off;
    RTCDevice device = rtcNewDevice("threads=1");
    RTCScene scene = rtcNewScene(device);
    if (robust) rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* to = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12,
                                       of_points);
    std::memcpy(to, points, 12 * of_points);
    to = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, of_faces);
    std::memcpy(to, faces, 12 * of_faces);
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(scene, mesh);
    rtcReleaseGeometry(mesh);
    rtcCommitScene(scene);
    return scene;
}

size_t peer_closest(void* scene, const Ray* rays, size_t count, double* sum) {
    NoSubnormals off;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    size_t hits = 0;
    double total = 0;
    for (size_t i = 0; i < count; ++i) {
        RTCRayHit asked;
        set(asked.ray, rays[i]);
        asked.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(static_cast<RTCScene>(scene), &context, &asked);
        if (asked.hit.geomID != RTC_INVALID_GEOMETRY_ID) {
            ++hits;
            total += asked.ray.tfar + asked.hit.Ng_x;
        }
    }
    *sum = total;
    return hits;
}

size_t peer_occluded(void* scene, const Ray* rays, size_t count) {
    NoSubnormals off;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    size_t hits = 0;
    for (size_t i = 0; i < count; ++i) {
        RTCRay asked;
        set(asked, rays[i]);
        rtcOccluded1(static_cast<RTCScene>(scene), &context, &asked);
        hits += asked.tfar < 0;
    }
    return hits;
}

size_t peer_closest_8(void* scene, const Ray* rays, size_t count, double* sum) {
    NoSubnormals off;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    size_t hits = 0;
    double total = 0;
    for (size_t i = 0; i < count; i += WIDTH) {
        alignas(32) int valid[WIDTH];
        alignas(32) RTCRayHit8 asked;
        set(asked.ray, valid, rays + i, count - i);
        for (size_t k = 0; k < WIDTH; ++k) asked.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect8(valid, static_cast<RTCScene>(scene), &context, &asked);
        for (size_t k = 0; k < WIDTH; ++k) {
            if (valid[k] && asked.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID) {
                ++hits;
                total += asked.ray.tfar[k] + asked.hit.Ng_x[k];
            }
        }
    }
    *sum = total;
    return hits;
}

size_t peer_occluded_8(void* scene, const Ray* rays, size_t count) {
    NoSubnormals off;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    size_t hits = 0;
    for (size_t i = 0; i < count; i += WIDTH) {
        alignas(32) int valid[WIDTH];
        alignas(32) RTCRay8 asked;
        set(asked, valid, rays + i, count - i);
        rtcOccluded8(valid, static_cast<RTCScene>(scene), &context, &asked);
        for (size_t k = 0; k < WIDTH; ++k) hits += valid[k] && asked.tfar[k] < 0;
    }
    return hits;
}
}
