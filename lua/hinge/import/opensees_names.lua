-- Names of the commands of OpenSees, for the recorders of Tcl and Python: what `import *` gives in Python, which names
-- have a result for a value, and which name a misspelt one is near to. A command that is not here is recorded too.
--
-- From the documentation of OpenSees and OpenSeesPy.
local names = {}

--- Their value is a result of the analysis, or is asked of the model.
names.results = "analyze basicDeformation basicForce basicStiffness betaResponse cdf computeGradients cbdiDisplacement "
  .. "eigen eleDynamicalForce eleForce eleNodes eleResponse eleType findID getCritMethod getCTestIter "
  .. "getCTestNorms getCrdTransfTags getDampingTags getEleClassTags getEleLoadClassTags getEleLoadData "
  .. "getEleLoadTags getEleTags getFixedDOFs getFixedNodes getConstrainedDOFs getConstrainedNodes "
  .. "getRetainedDOFs getRetainedNodes getLoadFactor getNDM getNDF getNodeLoadData getNodeLoadTags getNodeTags "
  .. "getNP getNumElements getNumThreads getParamTags getParamValue getPID getPatterns getStrain getStress "
  .. "getTangent getTime getMatTags getSecTags hystereticBackboneResponse isRecorder localForce modalProperties "
  .. "nodeAccel nodeBounds nodeCoord nodeCrd nodeDisp nodeDOFs nodeEigenvector nodeMass nodePressure "
  .. "nodeReaction nodeResponse nodeUnbalance nodeVel numFact numIter responseSpectrumAnalysis "
  .. "sectionDeformation sectionDisplacement sectionFlexibility sectionForce sectionLocation sectionResponseType "
  .. "sectionStiffness sectionTag sectionWeight sensNodeAccel sensNodeDisp sensNodePressure sensNodeVel "
  .. "sensSectionForce solveCPU systemSize testIter testNorm testNorms totalCPU version"

--- They compute, print or set how it is computed, and change no model. Records of two turns may differ in them.
names.quiet = "initialize pragma vrp vup vpn prp viewWindow plane port projection fill display reliability algorithm "
  .. "analysis barrier constraints convertBinaryToText convertTextToBinary database InitialStateAnalysis "
  .. "integrator logFile modalDamping modalDampingQ numberer partition print printA printB printGID printModel "
  .. "puts reactions record recorder save setMaxOpenFiles setNumThread setNumThreads setPrecision "
  .. "setStartNodeTag start stop system test video visual wipeAnalysis wipeReliability defaultUnits stripXML "
  .. "logCommands progress sensitivityAlgorithm runFORMAnalysis runFOSMAnalysis runSORMAnalysis "
  .. "runImportanceSamplingAnalysis"

--- They make or change the model.
names.model = "addToParameter background beamIntegration block2D block3D correlate damping dependentDOF domainChange "
  .. "eleLoad element equalDOF equalDOF_Mixed equationConstraint fiber fibre fix fixX fixY fixZ frictionModel "
  .. "geomTransf groundMotion hystereticBackbone imposedMotion imposedSupportMotion layer limitCurve load "
  .. "loadConst mass mesh model modulatingFunction nDMaterial ndMaterial node parameter patch pattern "
  .. "performanceFunction randomVariable rayleigh region remesh remove reset restore rigidDiaphragm rigidLink "
  .. "section setCreep setElementRayleighDampingFactors setElementRayleighFactors setNodeAccel setNodeCoord "
  .. "setNodeDisp setNodePressure setNodeTemperature setNodeVel setParameter setStrain setTime sp "
  .. "stiffnessDegradation strengthDegradation strengthControl timeSeries transformUtoX uniaxialMaterial "
  .. "unloadingRule updateElementDomain updateMaterialStage updateMaterials updateParameter wipe yieldSurface_BC "
  .. "ysEvolutionModel plasticMaterial cyclicModel"

--- In place of an argument that is not known: it hangs on a result of the analysis.
names.unknown = "\0"

return names
