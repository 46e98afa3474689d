#include "model/fracture_rule.h"

namespace hinge {

const std::vector<std::string> section_field_names = {"curvature_x",
                                                      "curvature_y",
                                                      "axial_strain",
                                                      "twist",
                                                      "plastic_curvature_x",
                                                      "plastic_curvature_y",
                                                      "plastic_axial_strain",
                                                      "plastic_twist",
                                                      "curvature_rate_x",
                                                      "curvature_rate_y",
                                                      "axial_strain_rate",
                                                      "twist_rate",
                                                      "Mx",
                                                      "My",
                                                      "N",
                                                      "Mz",
                                                      "f_y",
                                                      "plastic_work",
                                                      "shear_x",
                                                      "shear_y",
                                                      "hinge_rotation_x",
                                                      "hinge_rotation_y",
                                                      "member",
                                                      "element",
                                                      "end",
                                                      "node",
                                                      "plastic",
                                                      "broken",
                                                      "time",
                                                      "dt",
                                                      "step"};

double value_of(const SectionView& v, SectionField field) {
    switch (field) {
        case SectionField::curvature_x: return v.strain.curvature_x;
        case SectionField::curvature_y: return v.strain.curvature_y;
        case SectionField::axial_strain: return v.strain.axial;
        case SectionField::twist: return v.strain.twist;
        case SectionField::plastic_curvature_x: return v.plastic_strain.curvature_x;
        case SectionField::plastic_curvature_y: return v.plastic_strain.curvature_y;
        case SectionField::plastic_axial_strain: return v.plastic_strain.axial;
        case SectionField::plastic_twist: return v.plastic_strain.twist;
        case SectionField::curvature_rate_x: return v.strain_rate.curvature_x;
        case SectionField::curvature_rate_y: return v.strain_rate.curvature_y;
        case SectionField::axial_strain_rate: return v.strain_rate.axial;
        case SectionField::twist_rate: return v.strain_rate.twist;
        case SectionField::Mx: return v.force.Mx;
        case SectionField::My: return v.force.My;
        case SectionField::N: return v.force.N;
        case SectionField::Mz: return v.force.Mz;
        case SectionField::f_y: return v.f_y;
        case SectionField::plastic_work: return v.plastic_work;
        case SectionField::shear_x: return v.shear_x;
        case SectionField::shear_y: return v.shear_y;
        case SectionField::hinge_rotation_x: return v.hinge_rotation_x;
        case SectionField::hinge_rotation_y: return v.hinge_rotation_y;
        case SectionField::member: return v.member + 1;
        case SectionField::element: return v.element + 1;
        case SectionField::end: return v.end;
        case SectionField::node: return v.node + 1;
        case SectionField::plastic: return v.plastic;
        case SectionField::broken: return 0;
        case SectionField::time: return v.time;
        case SectionField::dt: return v.dt;
        case SectionField::step: return v.step;
    }
    return 0;
}

bool at_ends(SectionField field) {
    return field == SectionField::Mx || field == SectionField::My || field == SectionField::f_y ||
           field == SectionField::node || field == SectionField::plastic || field == SectionField::hinge_rotation_x ||
           field == SectionField::hinge_rotation_y;
}

}  // namespace hinge
