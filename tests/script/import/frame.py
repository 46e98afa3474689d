# Two bays by one bay, two storeys. Units: N, m, s.
import math
import openseespy.opensees as ops

E, G = 210e9, 210e9 / 2.6
bay, depth, height = 6.0, 5.0, 3.5
rho = 7850

ops.wipe()
ops.model('basic', '-ndm', 3, '-ndf', 6)


# nodes: 1 + i + 3 j + 6 k
for k in range(3):
    for j in range(2):
        for i in range(3):
            ops.node(1 + i + 3 * j + 6 * k, i * bay, j * depth, k * height)
for tag in range(1, 7):
    if tag == 3:
        ops.fix(tag, 1, 1, 1, 0, 0, 1)
    else:
        ops.fix(tag, *[1] * 6)

vectors = {1: (1, 0, 0), 2: (0, 0, 1), 3: (math.cos(math.pi / 6), math.sin(math.pi / 6), 0)}
for tag in [1, 2, 3]:
    ops.geomTransf('Linear', tag, *vectors[tag])

#        E, G, A, J, Iy, Iz, Avy, Avz
column = (E, G, 0.0149, 1.85e-6, 2.517e-4, 8.563e-5,
          0.0095, 0.0035)
tag = 0
for a in range(1, 13):
    tag += 1
    ops.element('ElasticTimoshenkoBeam', tag, a, a + 6, *column, 3 if tag == 8 else 1, '-mass', rho * column[2])

A, Iy, Iz, J = 0.00845, 2.313e-4, 1.318e-5, 5.1e-7
ops.section('Elastic', 1, E, A, Iz, Iy, G, J)
ops.beamIntegration('Lobatto', 1, 1, 5)
loaded = []
for level in (1, 2):
    for j in (0, 1):
        for a in [1 + i + 3 * j + 6 * level for i in range(2)]:
            tag += 1
            ops.element('elasticBeamColumn', tag, a, a + 1, A, E, G, J, Iy, Iz, 2, '-mass', rho * A)
            loaded.append(tag)
    for i in range(3):
        tag = tag + 1
        a = 1 + i + 6 * level
        ops.element('forceBeamColumn', tag, a, a + 3, 2, 1, '-mass', rho * A)

ops.timeSeries('Linear', 1)
ops.pattern('Plain', 1, 1)
for e in loaded:
    ops.eleLoad('-ele', e, '-type', '-beamUniform', 0.0, -12e3)
ops.pattern('Plain', 2, 1)
for node, fx, fy, mz in ((7, 20e3, 0, 0), (13, 35e3, 0, 4e3), (18, 12e3, 5e3, 0)):
    ops.load(node, fx, fy, 0, 0, 0, mz)
ops.eleLoad('-ele', 2, '-type', '-beamUniform', -1e3, -3e3)

ops.constraints('Plain')
ops.analysis('Static')
ops.analyze(1)
print(f"sway {ops.nodeDisp(13, 1):.5f}")
u = ops.nodeDisp(13, 1)
