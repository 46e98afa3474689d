-- Commands of OpenSees that say nothing about a frame: the analysis, its results, output, display and reliability.
local beside = {}
for name in ([[
  InitialStateAnalysis addToParameter algorithm analysis analyze barrier basicDeformation basicForce basicStiffness
  betaFORM betaResponse cdf close computeGradients constraints convertBinaryToText convertTextToBinary correlate
  correlateGroup database defaultUnits designVariable designPoint display domainChange eigen eleDynamicalForce
  eleForce eleNodes eleResponse eleType exit fill filter findCurvatures findDesignPoint functionEvaluator
  gFunEvaluator getCTestIter getCTestNorms getEleClassTags getEleLoadTags getEleTags getLSFTags getLoadFactor getNDF
  getNDM getNP getNodeLoadTags getNodeTags getNumElements getNumThreads getPID getParamTags getParamValue getPatterns
  getRVTags getTime gradGEvaluator gradientEvaluator gradientPerformanceFunction hessianEvaluator initialize
  integrator limitCurve localForce logCommands logFile meritFunctionCheck metaData modalProperties nodeAccel
  nodeBounds nodeCoord nodeDisp nodeEigenvector nodeMass nodePressure nodeReaction nodeResponse nodeUnbalance nodeVel
  numFact numIter numberer objectiveFunction parameter partition performanceFunction plane playback port pragma print
  printA printB printGID printModel probabilityTransformation progress projection prp pset puts randomNumberGenerator
  randomVariable reactions record recorder region reliability reliabilityConvergenceCheck remesh reset
  responseSpectrum responseSpectrumAnalysis rootFinding runFORMAnalysis runFOSMAnalysis runImportanceSamplingAnalysis
  runSORMAnalysis save searchDirection sectionDeformation sectionFlexibility sectionForce sectionStiffness
  sensNodeDisp sensitivityAlgorithm sensitivityIntegrator setElementRayleighFactors setMaxOpenFiles setNumThread
  setNumThreads setParameter setPrecision setTime solveCPU spectrum start startPoint stepSizeRule stop stripXML system
  systemSize test testIter testNorm testNorms totalCPU updateElementDomain updateMaterialStage updateMaterials
  updateParameter version video viewWindow visual vpn vrp vup wipeAnalysis wipeReliability]]):gmatch "%S+" do
  beside[name] = true
end
return beside
