// What a step of an elastic frame costs, us: compiled with all effects, and (HINGE_BARE) with none but those it calls
// for.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "core/built.h"
#include "run/dynamics.h"

using namespace hinge;

int main() {
    auto model = std::make_shared<Model>(ModelOptions{});
    auto steel = std::make_shared<Material>();
    steel->E = 206e9, steel->G = 79e9, steel->density = 7850;
    auto box = std::make_shared<Section>();
    box->area = 0.03, box->Ix = box->Iy = 4e-4, box->J = 6e-4, box->shear_area_x = box->shear_area_y = 0.015;
    constexpr int bays = 4, storeys = 8;
    int node[storeys + 1][bays + 1][bays + 1];
    for (int k = 0; k <= storeys; ++k)
        for (int i = 0; i <= bays; ++i)
            for (int j = 0; j <= bays; ++j) {
                node[k][i][j] = model->add_node(Vec3(6 * i, 6 * j, 4 * k));
                if (k == 0) model->fix(node[k][i][j], 63);
                else model->set_velocity(node[k][i][j], Vec3(1, 0, 0), Vec3::Zero());
            }
    const auto member = [&](int a, int b, const Vec3& up) { model->add_member({{a, b}, box, steel, up, 2, {}}); };
    for (int k = 1; k <= storeys; ++k)
        for (int i = 0; i <= bays; ++i)
            for (int j = 0; j <= bays; ++j) {
                member(node[k - 1][i][j], node[k][i][j], Vec3(1, 0, 0));
                if (i < bays) member(node[k][i][j], node[k][i + 1][j], Vec3(0, 0, 1));
                if (j < bays) member(node[k][i][j], node[k][i][j + 1], Vec3(0, 0, 1));
            }
    const auto structure = std::make_shared<const Structure>(model);
    DynamicSettings s;
    s.dt = 1e-5;
    s.duration = 1;
    Dynamics run(structure, initial_state(*structure), s);
    std::vector<double> seconds;
    for (int batch = 0; batch < 20; ++batch) {
        const auto start = std::chrono::steady_clock::now();
        for (int i = 0; i < 50; ++i)
            if (!run.advance()) return 1;  // a run that ended costs nothing a step
        seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / 50);
    }
    std::printf("%.3f %016llx\n", 1e6 * *std::min_element(seconds.begin(), seconds.end()),
                static_cast<unsigned long long>(hash(run.state())));
}
